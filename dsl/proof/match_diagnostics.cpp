#include "dsl/proof/match_diagnostics.h"

#include <algorithm>
#include <utility>

#include "dsl/load/intended_findings.h"
#include "dsl/load/loaded_file.h"

namespace af2::dsl {
namespace {

/// The place in the text of the rule's condition with this number.
std::optional<Span> conditionSpan(const Rule& rule, std::size_t number) {
  for (const Clause& clause : rule.clauses)
    if (const auto* require = std::get_if<RequireClause>(&clause.content)) {
      if (number < require->conditions.size()) return require->conditions[number].span;
      number -= require->conditions.size();
    }
  return std::nullopt;
}

/// The place in the text of the condition of the zone clause with this number.
std::optional<Span> whenSpan(const Rule& rule, int number) {
  for (const Clause& clause : rule.clauses)
    if (const auto* zone = std::get_if<ZoneClause>(&clause.content))
      if (number-- == 0) return zone->when.span;
  return std::nullopt;
}

Span spanOf(const CompiledRule& rule, const SampledFinding& finding) {
  const auto element = static_cast<std::size_t>(finding.element);
  if (finding.code == Code::InvertibleElement && element < rule.elementSpans.size())
    return rule.elementSpans[element];
  if (finding.code == Code::IdleClause && rule.text && finding.zone >= 0)
    return whenSpan(*rule.text, finding.zone).value_or(rule.title);
  if (finding.code == Code::IdleClause && rule.text)
    return conditionSpan(*rule.text, element).value_or(rule.title);
  const bool isAboutZone = finding.code == Code::UncoveredElement ||
                           finding.code == Code::InvalidZone || finding.code == Code::GrowingZone;
  if (isAboutZone && !rule.zoneSpans.empty()) return rule.zoneSpans.front();
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
  Diagnostic diagnostic(finding.code);
  diagnostic.severity = finding.severity;
  diagnostic.message = finding.message;
  diagnostic.help = finding.help;
  if (!finding.test.empty()) diagnostic.notes.push_back(testNote(finding.test));
  for (const std::string& test : finding.furtherTests) diagnostic.notes.push_back(testNote(test));
  return diagnostic;
}

bool covers(const DiagnosticPlace& outer, const DiagnosticPlace& inner) {
  return outer.file == inner.file &&
         std::pair(outer.line, outer.column) <= std::pair(inner.line, inner.column) &&
         std::pair(inner.endLine, inner.endColumn) <= std::pair(outer.endLine, outer.endColumn);
}

}  // namespace

DiagnosticNote testNote(const std::string& test) {
  return {onOneLine(test), std::nullopt, DiagnosticNote::Kind::Test};
}

std::set<std::size_t> unknownRules(const LoadedRules& loaded) {
  std::set<std::size_t> unknown;
  const std::vector<CompiledRule>& rules = loaded.file->rules;
  for (std::size_t i = 0; i < rules.size(); ++i)
    if (!rules[i].missing.empty()) unknown.insert(i);
  return unknown;
}

std::vector<Diagnostic> missingNamesIn(const LoadedRules& loaded) {
  std::vector<Diagnostic> diagnostics;
  const std::size_t count = unknownRules(loaded).size();
  for (const MissingName& missing : loaded.file->missing) {
    Diagnostic d = missingImplementation(missing);
    d.severity = Severity::Warning;
    d.notes.push_back({std::to_string(count) + (count == 1 ? " rule is" : " rules are") +
                           " checked by the text alone, and gaps between rules are not looked for",
                       std::nullopt});
    if (!isMeantToBe(*loaded.file, d)) diagnostics.push_back(std::move(d));
  }
  return diagnostics;
}

std::vector<Diagnostic> diagnosticsOf(const LoadedRules& loaded, const SampledResult& result) {
  std::vector<Diagnostic> diagnostics;
  for (const SampledFinding& finding : result.findings) {
    const CompiledRule& rule = loaded.file->rules[finding.rule];
    if (finding.code == Code::IdleClause && rule.isMirror)
      continue;  // the clause belongs to the rule itself
    Diagnostic diagnostic = diagnosticOf(finding);
    diagnostic.place = placeOf(rule.home->source, spanOf(rule, finding));
    diagnostic.rule = rule.definition.name;
    if (!isMeantToBe(*loaded.file, diagnostic)) diagnostics.push_back(std::move(diagnostic));
  }
  return diagnostics;
}

std::vector<Diagnostic> diagnosticsOf(const LoadedRules& loaded, const Coverage& coverage) {
  std::vector<SampledFinding> findings;
  if (coverage.closure) findings = findingsOf(*coverage.closure);
  if (auto finding = findUncoveredSituations(coverage)) findings.push_back(std::move(*finding));
  std::vector<Diagnostic> diagnostics;
  for (const SampledFinding& finding : findings) {
    Diagnostic diagnostic = diagnosticOf(finding);
    diagnostic.place.file = loaded.file->main().source.name();
    if (!isMeantToBe(*loaded.file, diagnostic)) diagnostics.push_back(std::move(diagnostic));
  }
  return diagnostics;
}

void addFinding(std::vector<Diagnostic>& told, Diagnostic finding) {
  if (finding.code == Code::NeverChosen && std::ranges::any_of(told, [&](const Diagnostic& d) {
        return d.code == Code::RedundantMirror && covers(d.place, finding.place);
      }))
    return;
  const auto same = std::ranges::find_if(told, [&](const Diagnostic& d) {
    return d.code == finding.code && d.place == finding.place && d.severity == finding.severity;
  });
  if (same == told.end() || finding.place.line == 0) {
    told.push_back(std::move(finding));
    return;
  }
  if (same->rule != finding.rule)
    same->notes.push_back({"the same holds for rule \"" + finding.rule + "\"", std::nullopt});
  else
    same->notes.insert(same->notes.end(), finding.notes.begin(), finding.notes.end());
}

}  // namespace af2::dsl
