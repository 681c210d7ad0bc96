// D4: a rule accepts its own reference match, at one of its levels.
//
// Only what is certain counts against a rule. What it asks of the front around the match is taken
// to be answered as it needs; and a rule that is meant for longer or shorter base edges is given
// those that the other checks look at.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "dsl/checks/accepted_scores.h"
#include "dsl/checks/checks.h"
#include "dsl/compile/allowed_codes.h"
#include "dsl/program/compiled_forms.h"
#include "engine/base/turn.h"
#include "engine/rule/rule_at_match.h"
#include "engine/step/rule_scoring.h"

namespace af2::dsl {
namespace {

/// Why the reference match is refused.
struct Objection {
  Refusal reason = Refusal::None;
  enum class Part { Vertex, Edge, Condition, NewVertex, Cost, Score } part = Part::Score;
  std::size_t index = 0;  ///< of a vertex, an edge, a condition, a new vertex
  int level = 1;
  double baseLength = 1;
  double value = 0, limit = 0;  ///< Pattern: the form and what is allowed; Score: of the elements
  double cost = 0;              ///< Score
};

/// A few digits; what rounding leaves of zero is zero.
std::string numberText(double value) {
  constexpr double kRounding = 1e-7;
  if (std::abs(value) < kRounding) value = 0;
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// Whether a program asks for what the reference match alone does not tell.
bool asksForMore(const Program& program, const RuleAtMatch& match) {
  return std::ranges::any_of(program.steps(), [&](const Step& step) {
    if (step.op == Op::Turn) return !match.turn(step.index);
    return operationOf(step.op).needs == Needs::Front || step.op == Op::Inside ||
           step.op == Op::Call;
  });
}

bool asksForMore(const AF2BindingFunction& function, const RuleAtMatch& match) {
  const auto* expression = dynamic_cast<const ExpressionFunction*>(&function);
  return !expression || asksForMore(expression->program(), match);
}

bool asksForMore(const AF2PointTransform& transform, const RuleAtMatch& match) {
  const auto* expression = dynamic_cast<const ExpressionTransform*>(&transform);
  return expression && asksForMore(expression->program(), match);
}

/// The reference match of a rule at a level, with a base edge of a certain length.
class ReferenceMatch {
 public:
  ReferenceMatch(const RuleDefinition& rule, const RuleSetDefinition& settings, int level,
                 double baseLength)
      : rule_(rule),
        settings_(settings),
        level_(level),
        baseLength_(baseLength),
        match_(rule, placesOf(rule, level, baseLength), level) {}

  /// Nothing if the match is accepted, or if that depends on the front around it.
  std::optional<Objection> objection() const {
    if (const auto found = misfit()) return found;
    if (const auto found = failedCondition()) return found;
    for (std::size_t i = 0; i < rule_.newVertices.size(); ++i) {
      if (asksForMore(*rule_.newVertices[i], match_)) return std::nullopt;
      if (!newVertexAt(rule_, i, match_.binding()))
        return objectionTo(Refusal::NoValue, Objection::Part::NewVertex, i);
    }
    return scoreObjection();
  }

 private:
  static std::vector<Point2> placesOf(const RuleDefinition& rule, int level, double baseLength) {
    std::vector<Point2> places = RuleAtMatch::atReference(rule, level).vertices();
    places[1] = {baseLength, 0};
    return places;
  }

  Objection objectionTo(Refusal reason, Objection::Part part, std::size_t index = 0) const {
    return {reason, part, index, level_, baseLength_};
  }

  std::optional<Objection> misfit() const {
    const double tolerance = settings_.matchTolerance[static_cast<std::size_t>(level_ - 1)];
    const RefusalCause cause = patternMisfit(rule_, match_.binding(), tolerance);
    if (cause.isNone()) return std::nullopt;
    Objection found = objectionTo(Refusal::Pattern,
                                  cause.isEdge ? Objection::Part::Edge : Objection::Part::Vertex,
                                  static_cast<std::size_t>(cause.index));
    found.value = cause.value;
    found.limit = cause.limit;
    return found;
  }

  std::optional<Objection> failedCondition() const {
    for (std::size_t i = 0; i < rule_.requirements.size(); ++i) {
      const AF2BindingFunction& condition = *rule_.requirements[i];
      if (asksForMore(condition, match_)) continue;
      const auto value = condition.evaluate(match_.binding());
      if (!value) return objectionTo(Refusal::NoValue, Objection::Part::Condition, i);
      if (*value == 0) return objectionTo(Refusal::Require, Objection::Part::Condition, i);
    }
    return std::nullopt;
  }

  std::optional<Objection> scoreObjection() const {
    const bool isKnown = !rule_.cost || !asksForMore(*rule_.cost, match_);
    const auto cost = isKnown ? costAt(rule_, match_.binding()) : 0;
    if (!cost) return objectionTo(Refusal::NoValue, Objection::Part::Cost);
    const auto vertices = match_.placeAll();
    if (!settings_.metric || !vertices) return std::nullopt;
    const RuleScoring scoring(settings_);
    double score = 0;
    const Refusal refusal = scoring.scoreElements(rule_.elements, vertices->data(), level_, score);
    if (refusal == Refusal::NoValue && measuresIdealElements())
      return objectionTo(refusal, Objection::Part::Score);
    if (refusal != Refusal::None || !isKnown ||
        scoring.judge(rule_.elements, vertices->data(), score + *cost, level_) == Refusal::None)
      return std::nullopt;
    const bool isByCost = rule_.cost && scoring.judge(rule_.elements, vertices->data(), score,
                                                      level_) == Refusal::None;
    Objection found =
        objectionTo(Refusal::Score, isByCost ? Objection::Part::Cost : Objection::Part::Score);
    found.value = score;
    found.cost = *cost;
    return found;
  }

  /// If it has no value for these either, the fault is that of the metric.
  bool measuresIdealElements() const {
    const double height = std::sqrt(3.0) / 2;
    const std::vector<Point2> triangle{{0, 0}, {1, 0}, {0.5, height}},
        square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    return std::ranges::all_of(rule_.elements, [&](const RuleElement& element) {
      const auto badness =
          settings_.metric->badnessAt(element.size() == 3 ? triangle : square, level_);
      return badness && std::isfinite(*badness);
    });
  }

  const RuleDefinition& rule_;
  const RuleSetDefinition& settings_;
  int level_;
  double baseLength_;
  RuleAtMatch match_;
};

/// How far the match is from being accepted; only among scores there is more and less.
double distanceToAcceptance(const Objection& one, const RuleSetDefinition& settings) {
  if (one.reason != Refusal::Score) return 0;
  const double score = one.value + one.cost;
  return score - acceptedBelow(*settings.acceptance, score, one.level).value_or(-score);
}

class ReferenceCheck {
 public:
  ReferenceCheck(const CheckedRules& rules, const CompiledRule& rule, Findings& findings)
      : rules_(rules), rule_(rule), settings_(rules.settings), findings_(findings) {}

  void run() {
    const int first = rule_.definition.firstLevel;
    const int last =
        std::min(rule_.definition.lastLevel.value_or(settings_.maxLevel), settings_.maxLevel);
    std::optional<Objection> mildest;
    for (int level = first; level <= last; ++level)
      for (const double baseLength : baseLengths()) {
        const auto found =
            ReferenceMatch(rule_.definition, settings_, level, baseLength).objection();
        if (!found) return;
        if (!mildest || isMilder(*found, *mildest)) mildest = found;
      }
    if (mildest) tell(*mildest, first != last);
  }

 private:
  /// The first one is that of the reference.
  std::vector<double> baseLengths() const {
    constexpr int kShortest = 14, kLongest = 28, kParts = 20;  // 0.7 to 1.4 in steps of 0.05
    std::vector<double> lengths{1};
    if (settings_.unit == ChartUnit::BaseLength) return lengths;
    for (int i = kShortest; i <= kLongest; ++i)
      if (i != kParts) lengths.push_back(static_cast<double>(i) / kParts);
    return lengths;
  }

  bool isMilder(const Objection& one, const Objection& other) const {
    if (one.reason != other.reason) return one.reason > other.reason;
    return distanceToAcceptance(one, settings_) < distanceToAcceptance(other, settings_);
  }

  Span placeOfPart(const Objection& one) const {
    switch (one.part) {
      case Objection::Part::Vertex:
        return rule_.vertexSpans[one.index];
      case Objection::Part::Edge:
        return rule_.edgeSpans[one.index];
      case Objection::Part::Condition:
        return rule_.conditions[one.index].span;
      case Objection::Part::NewVertex:
        return rule_.vertexSpans[rule_.definition.vertices.size() + one.index];
      case Objection::Part::Cost:
        return rule_.costSpan.value_or(rule_.title);
      case Objection::Part::Score:
        break;
    }
    return rule_.title;
  }

  std::string faultOf(const Objection& one) const {
    const std::string clause =
        one.part == Objection::Part::Condition ? "this condition"
        : one.part == Objection::Part::Cost    ? "its cost"
        : one.part == Objection::Part::NewVertex
            ? "the position of '" + rule_.definition.newVertexNames[one.index] + "'"
            : "the score of its elements";
    switch (one.reason) {
      case Refusal::Pattern:
        return "its tolerance does not allow the reference";
      case Refusal::Require:
        return clause + " does not hold there";
      case Refusal::NoValue:
        return clause + " has no value there";
      default:
        return "its score is not accepted there";
    }
  }

  /// "turn(b) is 60deg, dist(b, c) is 1"
  std::string comparedValues(const Objection& one) const {
    std::vector<Point2> places = RuleAtMatch::atReference(rule_.definition, one.level).vertices();
    places[1] = {one.baseLength, 0};
    const RuleAtMatch match(rule_.definition, std::move(places), one.level);
    std::string text;
    for (const ComparedValue& compared : rule_.conditions[one.index].compared) {
      const auto value = compared.value->evaluate(match.binding());
      if (!value) continue;
      const bool isAngle = compared.type == Type::Angle;
      text += (text.empty() ? "" : ", ") + compared.text + " is " +
              (isAngle ? numberText(*value * 360 / kFullTurn) + "deg" : numberText(*value));
    }
    return text.empty() && one.reason == Refusal::Require ? "it is false there" : text;
  }

  std::string valuesOf(const Objection& one) const {
    if (one.part == Objection::Part::Condition && one.reason == Refusal::Require)
      return comparedValues(one);
    if (one.reason == Refusal::Pattern)
      return "the deviation is " + numberText(one.value) + ", at most " + numberText(one.limit) +
             " is allowed";
    if (one.reason == Refusal::NoValue)
      return "a division by zero, a root of a negative number or the like";
    const double score = one.value + one.cost;
    std::string text = "the score is " + numberText(score);
    if (rule_.definition.cost)
      text += " (elements " + numberText(one.value) + ", cost " + numberText(one.cost) + ")";
    const auto limit = acceptedBelow(*settings_.acceptance, score, one.level);
    return text + (limit ? ", and `accept` allows less than " + numberText(*limit)
                         : ", and `accept` allows not even 0");
  }

  static std::string helpFor(const Objection& one) {
    switch (one.reason) {
      case Refusal::Pattern:
        return "give the clause a tolerance that holds the reference";
      case Refusal::Require:
        return "change the condition, or the reference position in `at`: a rule is written at a "
               "match that it accepts";
      case Refusal::NoValue:
        return "write it so that it has a value at the reference match";
      default:
        return one.part == Objection::Part::Cost ? "lower the cost, or accept higher scores"
                                                 : "accept higher scores, or make better elements";
    }
  }

  void tell(const Objection& one, bool hasLevels) {
    std::vector<DiagnosticNote> notes;
    const std::string isClosest =
        one.reason == Refusal::Score ? ", where it comes closest to being accepted" : "";
    if (hasLevels)
      notes.push_back({"it is refused at every level; the values are those of level " +
                           std::to_string(one.level) + isClosest,
                       {}});
    if (one.baseLength != 1)
      notes.push_back(
          {"the values are those for a base edge of length " + numberText(one.baseLength), {}});
    if (one.reason == Refusal::Score && rules_.acceptance)
      notes.push_back({"the rule set accepts scores here", rules_.acceptance});
    findings_.add(rule_, Code::RefusedReference, placeOfPart(one),
                  "this rule refuses its own reference match: " + faultOf(one), valuesOf(one),
                  helpFor(one), std::move(notes));
  }

  const CheckedRules& rules_;
  const CompiledRule& rule_;
  const RuleSetDefinition& settings_;
  Findings& findings_;
};

}  // namespace

void checkReferences(const CheckedRules& rules, Findings& findings) {
  if (rules.allowed.contains(Code::RefusedReference)) return;
  for (const CompiledRule& rule : rules.rules)
    if (!rule.text || !allows(*rule.text, Code::RefusedReference))
      ReferenceCheck(rules, rule, findings).run();
}

}  // namespace af2::dsl
