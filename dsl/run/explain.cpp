#include "dsl/run/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "dsl/run/piece_match.h"
#include "engine/base/segment.h"

namespace af2::dsl {
namespace {

/// How far a point lies from the outline of the zones.
double depthIn(const std::vector<std::vector<Point2>>& zones, Point2 point) {
  double depth = std::numeric_limits<double>::infinity();
  for (const auto& zone : zones)
    for (std::size_t i = 0; i < zone.size(); ++i)
      depth = std::min(depth, distanceToSegment(point, zone[i], zone[(i + 1) % zone.size()]));
  return depth;
}

class Explainer {
 public:
  Explainer(const RuleSet& rules, const FrontPiece& piece, const std::vector<std::string>& names)
      : rules_(rules), piece_(piece), names_(names), frame_(rules, piece) {}

  RuleExplanation explain(const RuleRefusal& refusal) const {
    RuleExplanation explanation;
    const AF2Rule& rule = rules_.rules()[refusal.rule];
    explanation.rule = rule.name();
    explanation.matches = refusal.matches;
    explanation.reason = refusal.reason;
    explanation.score = refusal.score;
    explanation.because = because(rule, refusal);
    return explanation;
  }

 private:
  std::string named(VertexId v) const {
    const Point2 at = frame_(piece_.vertices[v.value]);
    return fmt::format("{} at ({:.3g}, {:.3g})", names_[v.value], at.x, at.y);
  }

  std::string because(const AF2Rule& rule, const RuleRefusal& refusal) const {
    if (refusal.reason == Refusal::Class) return "";
    const auto match = matchInPiece(rules_, piece_, rule, refusal.matched);
    const EvalResult* evaluated = match ? &match->evaluated : nullptr;
    if (refusal.reason == Refusal::ZoneHitByVertex) {
      std::string text = "vertex " + named(refusal.from) + " lies in the zone";
      const double depth =
          evaluated ? depthIn(evaluated->zones, frame_(piece_.vertices[refusal.from.value]))
                    : std::numeric_limits<double>::infinity();
      return std::isfinite(depth) ? text + fmt::format(", {:.3g} from its outline", depth) : text;
    }
    if (refusal.reason == Refusal::ZoneHitByEdge)
      return "edge " + names_[refusal.from.value] + " -> " + named(refusal.to) +
             " crosses the zone";
    if (refusal.reason == Refusal::Pattern && refusal.matches == 0 && !evaluated)
      return "the front has fewer vertices here than the pattern";
    return evaluated ? evaluated->because : "";
  }

  const RuleSet& rules_;
  const FrontPiece& piece_;
  const std::vector<std::string>& names_;
  PieceFrame frame_;
};

bool passes(Refusal reason) { return reason == Refusal::None || reason == Refusal::Beaten; }

void findPassingLevels(const RuleSet& rules, SingleStepper& stepper, FrontPiece piece,
                       StepExplanation& explanation) {
  const auto isOpen = [](const RuleExplanation& rule) {
    return !passes(rule.reason) && !rule.passesAtLevel;
  };
  for (int level = piece.level + 1; level <= rules.maxLevel(); ++level) {
    if (std::ranges::none_of(explanation.rules, isOpen)) return;
    piece.level = level;
    const SingleStep step = stepper.take(piece);
    for (const RuleRefusal& refusal : step.refusals) {
      RuleExplanation& rule = explanation.rules[refusal.rule];
      if (isOpen(rule) && passes(refusal.reason)) rule.passesAtLevel = level;
    }
    if (step.rule && isOpen(explanation.rules[*step.rule]))
      explanation.rules[*step.rule].passesAtLevel = level;
  }
}

std::string resultText(const RuleExplanation& rule) {
  if (rule.reason == Refusal::None) return "applied";
  return toString(rule.reason);
}

std::string detailsText(const RuleExplanation& rule) {
  std::string text;
  const auto add = [&](const std::string& part) {
    if (!part.empty()) text += (text.empty() ? "" : "; ") + part;
  };
  if (passes(rule.reason) && rule.score) add(fmt::format("score {:.4g}", *rule.score));
  add(rule.because);
  if (rule.passesAtLevel) add(fmt::format("passes at level {}", *rule.passesAtLevel));
  return text;
}

/// The reason that the most rules were refused for, beyond that the pattern is not there.
std::optional<Refusal> mainCause(const StepExplanation& explanation) {
  std::vector<Refusal> reasons;
  for (const RuleExplanation& rule : explanation.rules) reasons.push_back(rule.reason);
  return dsl::mainCause(reasons);
}

}  // namespace

std::optional<Refusal> mainCause(const std::vector<Refusal>& reasons) {
  std::map<Refusal, int> counts;
  for (const Refusal reason : reasons)
    if (reason != Refusal::Class) ++counts[reason];
  if (counts.size() > 1) counts.erase(Refusal::Pattern);
  const auto most = std::ranges::max_element(counts, {}, [](const auto& c) { return c.second; });
  return most == counts.end() ? std::nullopt : std::optional(most->first);
}

StepExplanation explainStep(const RuleSet& rules, SingleStepper& stepper, const FrontPiece& piece,
                            const std::vector<std::string>& names, bool higherLevels) {
  const SingleStep step = stepper.take(piece);
  const Explainer explainer(rules, piece, names);
  StepExplanation explanation;
  explanation.level = piece.level;
  explanation.maxLevel = rules.maxLevel();
  explanation.applied = step.rule;
  explanation.rules.resize(rules.rules().size());
  for (const RuleRefusal& refusal : step.refusals)
    explanation.rules[refusal.rule] = explainer.explain(refusal);
  if (step.rule) {
    RuleExplanation& applied = explanation.rules[*step.rule];
    applied.rule = rules.rules()[*step.rule].name();
    applied.matches = 1;
    applied.score = step.score;
  }
  explanation.step = step;
  if (higherLevels) findPassingLevels(rules, stepper, piece, explanation);
  return explanation;
}

std::string toText(const StepExplanation& explanation, const std::string& indent,
                   const std::string& only) {
  std::size_t width = 4;
  std::size_t later = 0;
  for (const RuleExplanation& rule : explanation.rules) width = std::max(width, rule.rule.size());
  std::string text = fmt::format("{}{:{}}  matches  {:19}  why\n", indent, "rule", width, "result");
  for (const RuleExplanation& rule : explanation.rules) {
    if (!only.empty() && rule.rule != only) continue;
    if (rule.reason == Refusal::Class && only.empty()) {
      ++later;
      continue;
    }
    std::string line = fmt::format("{}{:{}}  {:7}  {:19}  {}", indent, rule.rule, width,
                                   rule.matches, resultText(rule), detailsText(rule));
    while (line.ends_with(' ')) line.pop_back();
    text += line + "\n";
  }
  if (later > 0)
    text += fmt::format("{}{} rule{} not tried at level {}\n", indent, later,
                        later == 1 ? " is" : "s are", explanation.level);
  if (explanation.applied || !only.empty()) return text;
  if (const auto cause = mainCause(explanation))
    text += fmt::format("{}most frequent reason: {}; {}\n", indent, toString(*cause),
                        remedyFor(*cause));
  return text;
}

std::string toText(const RuleExplanation& rule) {
  const std::string details = detailsText(rule);
  return details.empty() ? resultText(rule) : resultText(rule) + "; " + details;
}

std::string toJson(const StepExplanation& explanation) {
  nlohmann::ordered_json json{{"level", explanation.level}, {"rules", nlohmann::json::array()}};
  if (explanation.applied)
    json["applied"] = explanation.rules[*explanation.applied].rule;
  else
    json["applied"] = nullptr;
  for (const RuleExplanation& rule : explanation.rules) {
    nlohmann::ordered_json entry{
        {"rule", rule.rule}, {"matches", rule.matches}, {"result", resultText(rule)}};
    if (!rule.because.empty()) entry["because"] = rule.because;
    if (rule.score) entry["score"] = *rule.score;
    if (rule.passesAtLevel) entry["passes_at_level"] = *rule.passesAtLevel;
    json["rules"].push_back(std::move(entry));
  }
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

const char* remedyFor(Refusal reason) {
  switch (reason) {
    case Refusal::None:
      return "";
    case Refusal::Class:
      return "lower the rule's `quality`, or raise the rule set's last level";
    case Refusal::Pattern:
      return "write a rule for this shape of the front, or let a tolerance grow with the level";
    case Refusal::Require:
      return "relax the condition that is named";
    case Refusal::NoValue:
      return "write the expression so that it has a value here";
    case Refusal::Parity:
      return "no remedy in the rule: its edges would leave a loop that quadrilaterals cannot fill";
    case Refusal::Clearance:
      return "let `clear` fall with the level, or write a rule that uses the vertices there";
    case Refusal::Shape:
    case Refusal::Convexity:
      return "write the zone as poly(...), or place its corners so that it stays valid here";
    case Refusal::ZoneHitByVertex:
    case Refusal::ZoneHitByEdge:
      return "let the zone shrink with the level (`=>`), or write a rule that uses what is in the "
             "zone";
    case Refusal::Inverted:
      return "place the new vertices so that all new elements turn left here";
    case Refusal::Weld:
      return "no remedy in the rule: the mesh would not stay sound";
    case Refusal::Score:
      return "let `accept` grow with the level, or write a rule that makes better elements here";
    case Refusal::Surface:
      return "use a smaller mesh size here: the surface bends too much for elements of this size";
    case Refusal::Beaten:
      return "give the rule a lower `cost` or `priority`";
  }
  return "";
}

}  // namespace af2::dsl
