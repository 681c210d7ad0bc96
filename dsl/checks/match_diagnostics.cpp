#include "dsl/checks/match_diagnostics.h"

#include <algorithm>

namespace af2::dsl {
namespace {

/// Whether the rule's text says that it knows: the value of `allow` is a list of codes.
bool allows(const Rule& rule, const std::string& code) {
  for (const Clause& clause : rule.clauses) {
    const auto* meta = std::get_if<MetaClause>(&clause.content);
    if (!meta) continue;
    for (const MetaEntry& entry : meta->entries)
      if (entry.key.text == "allow" && entry.value.text.find(code) != std::string::npos)
        return true;
  }
  return false;
}

/// Where the rule's condition of that number is written.
std::optional<Span> conditionSpan(const Rule& rule, std::size_t number) {
  for (const Clause& clause : rule.clauses)
    if (const auto* require = std::get_if<RequireClause>(&clause.content)) {
      if (number < require->conditions.size()) return require->conditions[number].span;
      number -= require->conditions.size();
    }
  return std::nullopt;
}

Span spanOf(const CompiledRule& rule, const SampledFinding& finding) {
  const auto element = static_cast<std::size_t>(finding.element);
  if (finding.code == "G2" && element < rule.elementSpans.size()) return rule.elementSpans[element];
  if (finding.code == "D1" && rule.text)
    return conditionSpan(*rule.text, element).value_or(rule.title);
  if (finding.code[0] == 'Z' && !rule.zoneSpans.empty()) return rule.zoneSpans.front();
  return rule.title;
}

std::string onOneLine(const std::string& text) {
  std::string line;
  for (const char c : text) {
    if (c == '\n' || c == ' ') {
      if (!line.empty() && line.back() != ' ') line += ' ';
    } else {
      line += c;
    }
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

Diagnostic diagnosticOf(const SampledFinding& finding) {
  Diagnostic diagnostic;
  diagnostic.severity = finding.severity;
  diagnostic.code = finding.code;
  diagnostic.message = finding.message;
  diagnostic.help = finding.help;
  if (!finding.test.empty()) diagnostic.notes.push_back({onOneLine(finding.test), std::nullopt});
  for (const std::string& test : finding.furtherTests)
    diagnostic.notes.push_back({onOneLine(test), std::nullopt});
  return diagnostic;
}

}  // namespace

std::vector<Diagnostic> diagnosticsOf(const LoadedRules& loaded, const SampledResult& result) {
  std::vector<Diagnostic> diagnostics;
  for (const SampledFinding& finding : result.findings) {
    const CompiledRule& rule = loaded.file->rules[finding.rule];
    if (rule.text && allows(*rule.text, finding.code)) continue;
    if (finding.code == "D1" && rule.isMirror) continue;  // the clause is the rule's own
    Diagnostic diagnostic = diagnosticOf(finding);
    diagnostic.place = placeOf(rule.home->source, spanOf(rule, finding));
    diagnostic.rule = rule.definition.name;
    diagnostics.push_back(std::move(diagnostic));
  }
  return diagnostics;
}

std::vector<Diagnostic> diagnosticsOf(const LoadedRules& loaded, const Coverage& coverage) {
  const auto finding = findUncoveredSituations(coverage);
  if (!finding) return {};
  Diagnostic diagnostic = diagnosticOf(*finding);
  diagnostic.place.file = loaded.file->main().source.name();
  return {diagnostic};
}

}  // namespace af2::dsl
