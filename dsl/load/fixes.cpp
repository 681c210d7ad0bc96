#include "dsl/load/fixes.h"
#include "dsl/load/loaded_file.h"

#include <algorithm>
#include <array>

namespace af2::dsl {
namespace {

/// Counts errors by stage (words and clauses, names and types, rules), then warnings. Earlier
/// faults hide later ones, so fewer errors of an early stage are better, even if more later faults
/// appear.
std::array<std::size_t, 4> faultsOf(const LoadedRules& loaded) {
  std::array<std::size_t, 4> counts{};
  for (const Diagnostic& d : loaded.diagnostics) {
    const bool isError = d.severity == Severity::Error;
    ++counts[isError ? static_cast<std::size_t>(infoOf(d.code).stage) : 3];
  }
  return counts;
}

std::string edited(const std::string& text, const TextEdit& edit) {
  std::string result = text;
  return result.replace(edit.span.begin, edit.span.end - edit.span.begin, edit.replacement);
}

}  // namespace

std::vector<TextEdit> editsFor(const LoadedRules& loaded) {
  const SourceText& source = loaded.file->main().source;
  std::vector<TextEdit> edits;
  for (const Diagnostic& diagnostic : loaded.diagnostics)
    for (const SuggestedEdit& edit : diagnostic.edits) {
      const DiagnosticPlace& at = edit.place;
      if (at.file != source.name() || at.line == 0) continue;
      edits.push_back(
          {{source.offsetOf({at.line, at.column}), source.offsetOf({at.endLine, at.endColumn})},
           edit.replacement,
           edit.what});
    }
  return edits;
}

FixedText fixText(const std::string& name, std::string text, const LoadOptions& options,
                  const DropFindings& drop) {
  constexpr int kMaxTries = 500;
  FixedText fixed{std::move(text), {}};
  const auto load = [&](const std::string& candidate) {
    LoadedRules result = loadRulesFromText(name, candidate, options);
    if (drop && result.rules) drop(result, result.diagnostics);
    return result;
  };
  LoadedRules loaded = load(fixed.text);
  int tries = 0;
  for (bool isBetter = true; isBetter;) {
    isBetter = false;
    for (const TextEdit& edit : editsFor(loaded)) {
      if (++tries > kMaxTries) return fixed;
      std::string candidate = edited(fixed.text, edit);
      LoadedRules then = load(candidate);
      if (faultsOf(then) >= faultsOf(loaded)) continue;
      fixed.text = std::move(candidate);
      fixed.done.push_back(edit.what);
      loaded = std::move(then);
      isBetter = true;
      break;
    }
  }
  return fixed;
}

}  // namespace af2::dsl
