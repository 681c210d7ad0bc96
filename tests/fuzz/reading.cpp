#include "tests/fuzz/reading.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "dsl/evaluate.h"
#include "dsl/printer.h"
#include "dsl/rls_import.h"
#include "dsl/rule_file.h"
#include "dsl/rule_tests.h"
#include "engine/error.h"
#include "geometry/planar/poly_file.h"

namespace af2::fuzz {
namespace {

using dsl::Diagnostic;

void promise(bool holds, const char* what) {
  if (!holds) throw std::logic_error(std::string("does not hold: ") + what);
}

/// Every finding has a place in its file and can be written in every form.
void checkFindings(const std::vector<Diagnostic>& found, const std::string& text) {
  const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
  promise(found.size() <= dsl::DiagnosticList::kMost, "at most so many findings as are shown");
  for (const Diagnostic& d : found) {
    promise(!d.message.empty() && !d.code.empty(), "a finding has a code and a message");
    promise(d.place.line >= 0 && d.place.line <= lines, "a finding lies in the file");
    promise(d.place.column >= 0 && d.place.endLine >= d.place.line, "its span runs forwards");
  }
  promise(!dsl::toPretty(found).empty() || found.empty(), "findings can be written");
  promise(!dsl::toJson(found).empty() && !dsl::toSarif(found).empty(), "for machines, too");
}

/// Formatting gives the same rules, and formatting again the same text.
void checkFormat(const std::string& text, const dsl::LoadedRules& loaded) {
  const std::string once = dsl::format("x.af2", text).text;
  if (once.empty()) return;
  promise(dsl::format("x.af2", once).text == once, "formatting twice changes nothing");
  const dsl::LoadedRules again = dsl::loadRulesFromText("x.af2", once);
  promise((again.rules == nullptr) == (loaded.rules == nullptr), "formatting keeps what is sound");
  if (!loaded.rules) return;
  promise(again.rules->rules().size() == loaded.rules->rules().size(), "formatting keeps rules");
}

/// The first rules at their reference match.
void evaluateSome(const RuleSet& rules) {
  constexpr std::size_t kMost = 5;
  for (std::size_t i = 0; i < std::min(kMost, rules.rules().size()); ++i) {
    dsl::EvalRequest request;
    request.rule = rules.rules()[i].name();
    request.points = {{0.5, 0.3}, {2, 2}};
    request.segments = {{{-1, 0.5}, {2, 0.5}}};
    try {
      promise(!dsl::toJson(dsl::evaluateRule(rules, request)).empty(), "an answer can be written");
    } catch (const InputError&) {
      // level 1 lies outside of the rule's levels
    }
  }
}

}  // namespace

void tryRuleFile(const std::string& text) {
  const dsl::LoadedRules loaded = dsl::loadRulesFromText("x.af2", text);
  promise((loaded.rules == nullptr) == dsl::hasErrors(loaded.diagnostics),
          "there are rules, or errors");
  checkFindings(loaded.diagnostics, text);
  checkFormat(text, loaded);
  if (!loaded.rules) return;
  evaluateSome(*loaded.rules);
  dsl::runRuleTests(loaded);
}

void tryRlsFile(const std::string& text) {
  const dsl::ImportedRules imported = dsl::importRls("x.rls", text);
  checkFindings(imported.diagnostics, text);
  promise(imported.text.empty() == dsl::hasErrors(imported.diagnostics), "a text, or errors");
  if (imported.text.empty()) return;
  promise(!dsl::format("x.af2", imported.text).text.empty(), "an imported file can be read");
}

void tryPolyFile(const std::string& text) {
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("af2-" + std::to_string(getpid()) + ".poly"))
          .string();
  std::ofstream(path, std::ios::binary) << text;
  try {
    geometry::readPoly(path);
  } catch (const InputError&) {
    // told
  }
  std::filesystem::remove(path);
}

}  // namespace af2::fuzz
