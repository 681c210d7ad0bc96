#include "cli/rules/rule_findings.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <set>
#include <tuple>

#include "cli/program/text_files.h"
#include "cli/program/usage_error.h"
#include "cli/rules/rule_files.h"
#include "dsl/load/loaded_file.h"
#include "dsl/picture/coverage_picture.h"
#include "dsl/picture/rule_picture.h"
#include "dsl/proof/coverage.h"
#include "dsl/proof/match_diagnostics.h"
#include "dsl/proof/proven_errors.h"

namespace af2::cli {
namespace {

using dsl::Diagnostic;

/// A file name made from free text such as a title.
std::string fileNameOf(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const bool isPlain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (isPlain) name += c;
    if (!isPlain && !name.empty() && name.back() != '-') name += '-';
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name;
}

/// Writes the pictures to which findings refer.
class PictureFolder {
 public:
  explicit PictureFolder(std::string folder) : folder_(std::move(folder)) {
    std::error_code error;
    if (isWanted()) std::filesystem::create_directories(folder_, error);
    if (error) throw UsageError(fmt::format("cannot create the folder '{}'", folder_));
  }

  bool isWanted() const { return !folder_.empty(); }

  void add(Diagnostic& diagnostic, const std::string& stem, const std::string& svg) {
    std::string name = fileNameOf(stem);
    for (int n = 2; !used_.insert(name).second; ++n)
      name = fmt::format("{}-{}", fileNameOf(stem), n);
    const std::string path = (std::filesystem::path(folder_) / (name + ".svg")).string();
    writeText(path, svg);
    diagnostic.notes.push_back({"picture: " + path, std::nullopt});
  }

 private:
  std::string folder_;
  std::set<std::string> used_;
};

std::string drawExample(const dsl::LoadedRules& loaded, const dsl::SampledFinding& finding) {
  dsl::DrawnMatch match{finding.example.vertices, finding.example.level, finding.example.marks,
                        finding.message};
  match.marks.insert(match.marks.end(), finding.example.obstacles.begin(),
                     finding.example.obstacles.end());
  return dsl::drawMatch(*loaded.rules, loaded.rules->rules()[finding.rule], match,
                        dsl::PictureFormat::Svg);
}

/// Findings from the text alone have no counter-example yet; this adds one.
void addMirrorExamples(const std::string& stem, const dsl::LoadedRules& loaded,
                       PictureFolder& pictures, std::vector<Diagnostic>& diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    const auto found = dsl::mirrorExampleOf(loaded, diagnostic);
    if (!found) continue;
    diagnostic.notes.push_back(dsl::testNote(found->test));
    if (!pictures.isWanted()) continue;
    const dsl::DrawnMatch match{found->example.vertices,
                                found->example.level,
                                {},
                                diagnostic.message + ": what it would do"};
    pictures.add(diagnostic,
                 fmt::format("{} {} {}", stem, dsl::idOf(diagnostic.code), diagnostic.rule),
                 dsl::drawMatch(*loaded.rules, *found->image, match, dsl::PictureFormat::Svg));
  }
}

void addMatchFindings(const std::string& stem, const dsl::LoadedRules& loaded,
                      const dsl::SampledResult& result, PictureFolder& pictures,
                      std::vector<Diagnostic>& into) {
  for (const dsl::SampledFinding& finding : result.findings) {
    dsl::SampledResult one;
    one.findings = {finding};
    for (Diagnostic& diagnostic : dsl::diagnosticsOf(loaded, one)) {
      if (pictures.isWanted()) {
        pictures.add(diagnostic,
                     fmt::format("{} {} {}", stem, dsl::idOf(diagnostic.code), diagnostic.rule),
                     drawExample(loaded, finding));
      }
      dsl::addFinding(into, std::move(diagnostic));
    }
  }
}

void addCoverageFindings(const std::string& stem, const dsl::LoadedRules& loaded,
                         PictureFolder& pictures, std::vector<Diagnostic>& into) {
  const dsl::Coverage coverage = dsl::measureCoverage(*loaded.rules);
  for (Diagnostic& diagnostic : dsl::diagnosticsOf(loaded, coverage)) {
    if (pictures.isWanted()) {
      pictures.add(diagnostic, fmt::format("{} {}", stem, dsl::idOf(diagnostic.code)),
                   dsl::drawCoverage(coverage, loaded.rules->name(), dsl::PictureFormat::Svg));
    }
    into.push_back(std::move(diagnostic));
  }
}

void countAnswers(const dsl::SampledResult& result, RuleFindings& findings) {
  for (const dsl::RuleAnswers& answer : result.answers) {
    const auto is = [&](dsl::Answer what) {
      return answer.positive == what || answer.covered == what;
    };
    if (!answer.isTried) continue;
    if (is(dsl::Answer::Refuted))
      ++findings.refuted;
    else if (is(dsl::Answer::Sampled))
      ++findings.sampled;
    else
      ++findings.proven;
  }
}

void drop(std::vector<Diagnostic>& diagnostics, const std::vector<dsl::Code>& allowed) {
  std::erase_if(diagnostics, [&](const Diagnostic& d) {
    return std::ranges::find(allowed, d.code) != allowed.end();
  });
}

/// Findings of the main file come first; those of its imports follow, file by file.
void sortByPlace(std::vector<Diagnostic>& diagnostics, const std::string& mainFile) {
  std::ranges::stable_sort(diagnostics, {}, [&](const Diagnostic& d) {
    return std::tuple(d.place.file != mainFile, d.place.file, d.place.line, d.place.column);
  });
}

}  // namespace

RuleFindings provenErrorsIn(const dsl::LoadedRules& loaded) {
  RuleFindings findings;
  findings.ruleCount = loaded.rules->rules().size();
  dsl::ProvenErrors errors = dsl::findProvenErrors(loaded);
  countAnswers(errors.result, findings);
  findings.diagnostics = std::move(errors.diagnostics);
  return findings;
}

RuleFindings findIn(const std::string& name, const FindingOptions& options) {
  RuleFindings findings;
  dsl::LoadedRules loaded =
      loadRuleFile(name, {options.plugins, dsl::Externs::Declared, options.allowed});
  findings.diagnostics = loaded.diagnostics;
  std::ranges::move(dsl::missingNamesIn(loaded), std::back_inserter(findings.diagnostics));
  drop(findings.diagnostics, options.allowed);
  sortByPlace(findings.diagnostics, std::string(loaded.file->main().source.name()));
  findings.ruleCount = loaded.file->rules.size();
  const bool isWhole = loaded.rules != nullptr && loaded.file->missing.empty();
  loaded.rules = loaded.file->soundRules;
  if (!loaded.rules || options.quick) return findings;

  PictureFolder pictures(options.pictures);
  dsl::SamplingOptions sampling;
  if (options.samples > 0) sampling.samples = options.samples;
  if (options.prove) sampling.effort = dsl::kGreatEffort;
  sampling.unknown = dsl::unknownRules(loaded);
  if (isWhole) dsl::dropIdleMirrors(loaded, findings.diagnostics);
  addMirrorExamples(stemOf(name), loaded, pictures, findings.diagnostics);
  const dsl::SampledResult result = dsl::runSampledChecks(*loaded.rules, sampling);
  countAnswers(result, findings);
  addMatchFindings(stemOf(name), loaded, result, pictures, findings.diagnostics);
  // The choice among rules, and its gaps, can be judged only if all rules are sound and known.
  if (isWhole)
    addCoverageFindings(stemOf(name), loaded, pictures, findings.diagnostics);
  else
    drop(findings.diagnostics, {dsl::Code::NeverChosen});
  drop(findings.diagnostics, options.allowed);
  sortByPlace(findings.diagnostics, std::string(loaded.file->main().source.name()));
  return findings;
}

}  // namespace af2::cli
