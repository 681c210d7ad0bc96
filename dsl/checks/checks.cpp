#include "dsl/checks/checks.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

#include "dsl/program/compiled_forms.h"
#include "dsl/program/known_values.h"
#include "engine/rule/rule_at_match.h"

namespace af2::dsl {

// Each check is defined in its own file.
void checkPattern(const CheckedRules& rules, Findings& findings);
void checkTopology(const CheckedRules& rules, Findings& findings);
void checkOrientation(const CheckedRules& rules, Findings& findings);
void checkProgress(const CheckedRules& rules, Findings& findings);
void checkParity(const CheckedRules& rules, Findings& findings);
void checkColours(const CheckedRules& rules, Findings& findings);
void checkActs(const CheckedRules& rules, Findings& findings);
void checkMirrors(const CheckedRules& rules, Findings& findings);
void checkLevels(const CheckedRules& rules, Findings& findings);
void checkZones(const CheckedRules& rules, Findings& findings);
void checkReferences(const CheckedRules& rules, Findings& findings);

namespace {

constexpr std::array kChecks{
    Check{0,
          {Code::MalformedPattern},
          "Are chains, vertices and elements named as they should be?",
          checkPattern},
    Check{0, {Code::UnreachedLevels}, "Is every rule tried at some level?", checkLevels, true},
    Check{1, {Code::OpenTopology}, "Do elements and pattern close up?", checkTopology},
    Check{1, {Code::NoProgress}, "Does every step make progress?", checkProgress},
    Check{1,
          {Code::WeldOperands, Code::UnendingAct},
          "Do welds and paths shorten or divide loops?",
          checkActs},
    Check{1,
          {Code::InvertedElement},
          "Are the elements positive at the reference match?",
          checkOrientation,
          false,
          true},
    Check{2,
          {Code::InvalidZone, Code::UnboundedZone, Code::ClockwiseZone},
          "Is the zone a bounded region, counter-clockwise, at the reference match?",
          checkZones,
          true,
          true},
    Check{2, {Code::BrokenParity}, "Does every rule keep the parity of the front?", checkParity},
    Check{3, {Code::ClashingColours}, "Can loops with two colours have its edges?", checkColours},
    Check{2,
          {Code::MissingMirror, Code::RedundantMirror},
          "Has every rule its mirror image, once?",
          checkMirrors,
          false,
          true},
    Check{3,
          {Code::RefusedReference},
          "Does every rule accept its own reference match?",
          checkReferences,
          false,
          true},
};

/// Whether a rule calls a name that nothing implements.
bool isUnknown(const CompiledRule& rule) { return !rule.missing.empty(); }

bool isNeverTried(const CheckedRules& given, const std::string& title) {
  return std::ranges::any_of(given.rules, [&](const CompiledRule& rule) {
    return rule.definition.name == title && rule.definition.firstLevel > given.settings.maxLevel;
  });
}

/// A rule whose level is never reached is never tried. Its errors are reported, but do not prevent
/// the other rules from being used.
void excuse(Diagnostic& d) {
  d.severity = Severity::Warning;
  d.notes.push_back({"this rule is never tried, so the other rules can be used", {}});
}

}  // namespace

std::span<const Check> checks() { return kChecks; }

void Findings::add(const CompiledRule& rule, Code code, Span span, std::string message,
                   std::string label, std::string help, std::vector<DiagnosticNote> notes,
                   std::vector<SuggestedEdit> edits) {
  Diagnostic d(code);
  if (d.severity == Severity::Error) faulty_.insert(rule.definition.name);
  d.message = std::move(message);
  d.label = std::move(label);
  d.help = std::move(help);
  d.notes = std::move(notes);
  d.edits = std::move(edits);
  d.rule = rule.definition.name;
  d.place = placeOf(rule.home->source, span);
  diagnostics_.add(std::move(d));
}

std::vector<CompiledRule> runChecks(const CheckedRules& given, DiagnosticList& diagnostics) {
  std::vector<CompiledRule> sound(given.rules.begin(), given.rules.end());
  std::set<std::string> faulty;
  std::vector<DiagnosticPlace> toldPlaces;
  const auto isTold = [&](const DiagnosticPlace& place) {
    return std::ranges::find(toldPlaces, place) != toldPlaces.end();
  };
  int stage = 0;
  for (const Check& check : kChecks) {
    if (check.stage != std::exchange(stage, check.stage))
      std::erase_if(
          sound, [&](const CompiledRule& rule) { return faulty.contains(rule.definition.name); });
    DiagnosticList found;
    Findings findings(found);
    std::span<const CompiledRule> shown = check.standsAlone ? given.rules : sound;
    std::vector<CompiledRule> known;
    if (check.evaluates && std::ranges::any_of(shown, isUnknown)) {
      std::ranges::remove_copy_if(shown, std::back_inserter(known), isUnknown);
      shown = known;
    }
    check.run({shown, given.settings, given.main, given.allowed, given.acceptance}, findings);
    faulty.insert(findings.faulty().begin(), findings.faulty().end());
    for (Diagnostic& d : found.take()) {
      // A rule with errors may be the missing mirror image, so mirror images cannot be checked.
      if (d.code == Code::MissingMirror && diagnostics.hasErrors()) continue;
      if (d.severity == Severity::Error) {
        if (isTold(d.place)) continue;
        toldPlaces.push_back(d.place);
        if (isNeverTried(given, d.rule)) excuse(d);
      }
      diagnostics.add(std::move(d));
    }
  }
  std::erase_if(sound,
                [&](const CompiledRule& rule) { return faulty.contains(rule.definition.name); });
  return sound;
}

std::string vertexName(const CompiledRule& rule, int vertex) {
  const auto index = static_cast<std::size_t>(vertex);
  const auto& d = rule.definition;
  return index < d.vertices.size() ? d.vertices[index].name
                                   : d.newVertexNames[index - d.vertices.size()];
}

namespace {

/// Whether a condition refuses every match at this level.
bool isRefusedAt(const RuleDefinition& rule, int level) {
  return std::ranges::any_of(rule.requirements, [&](const auto& requirement) {
    const auto* function = dynamic_cast<const ExpressionFunction*>(requirement.get());
    return function && KnownResults(function->program(), level)[0].isFalse();
  });
}

}  // namespace

std::vector<int> referenceLevels(const RuleDefinition& rule) {
  constexpr int kTried = 50;  // levels, to find the first one with a match
  int first = rule.firstLevel;
  while (first < rule.lastLevel.value_or(rule.firstLevel + kTried) && isRefusedAt(rule, first))
    ++first;
  int last = first;
  for (const PatternVertex& v : rule.vertices) last = std::max(last, v.reference.levelCount());
  last = std::min(last, rule.lastLevel.value_or(last));
  std::vector<int> levels{first};
  for (int level = first + 1; level <= last; ++level)
    if (std::ranges::any_of(rule.vertices, [&](const PatternVertex& v) {
          return v.reference.at(level) != v.reference.at(level - 1);
        }))
      levels.push_back(level);
  return levels;
}

std::string belowBase(const CompiledRule& rule, int level) {
  const auto points = referencePositions(rule, level);
  for (std::size_t i = 2; points && i < points->size(); ++i)
    if ((*points)[i].y < 0)
      return "'" + vertexName(rule, static_cast<int>(i)) +
             "' lies below the base edge, where everything is meshed; the region still to be "
             "meshed "
             "has y > 0";
  return {};
}

std::string referenceName(const CompiledRule& rule, int level) {
  return referenceLevels(rule.definition).size() == 1
             ? "the reference match"
             : "the reference match of level " + std::to_string(level);
}

std::optional<std::vector<Point2>> referencePositions(const CompiledRule& rule, int level) {
  return RuleAtMatch::atReference(rule.definition, level).placeAll();
}

}  // namespace af2::dsl
