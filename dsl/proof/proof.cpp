#include "dsl/proof/proof.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "dsl/proof/branch_and_bound.h"
#include "dsl/proof/claim.h"
#include "dsl/proof/rule_graph.h"

namespace af2::dsl {
namespace {

Corners cornersOf(const RuleGraph& graph, const RuleElement& element) {
  Corners corners;
  for (int i = 0; i < element.size(); ++i)
    corners.push_back(
        graph.placed()[static_cast<std::size_t>(element.corners[static_cast<std::size_t>(i)])]);
  return corners;
}

/// The three corners at each vertex of an element, whose orientation must be positive; a triangle
/// needs one vertex only.
std::vector<std::array<NodePair, 3>> turnsOf(const Corners& corners) {
  std::vector<std::array<NodePair, 3>> turns;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < (n == 3 ? 1 : n); ++i)
    turns.push_back({corners[i], corners[(i + 1) % n], corners[(i + 2) % n]});
  return turns;
}

/// Assumptions under which one of the alternatives of the zone is used.
Circumstances circumstancesOf(RuleGraph& graph, const GraphZone& zone) {
  Circumstances given;
  given.truths = zone.truths;
  given.untruths = zone.untruths;
  for (const Node truth : zone.truths) graph.addConsequences(truth, given.facts);
  for (const Node untruth : zone.untruths) graph.addOpposites(untruth, given.facts);
  if (zone.shape) addShapeFacts(graph, *zone.shape, given.facts);
  return given;
}

std::vector<LinearPoint> convexCorners(const RuleGraph& graph, const GraphZone& zone) {
  std::vector<LinearPoint> corners;
  if (zone.shape && zone.shape->kind == ShapeKind::Convex)
    for (const NodePair p : zone.shape->points) corners.push_back(graph.linear(p));
  return corners;
}

bool isPositiveIn(RuleGraph& graph, const AF2Rule& rule, const GraphZone& zone,
                  ProofEffort& effort) {
  const auto corners = convexCorners(graph, zone);
  Circumstances given = circumstancesOf(graph, zone);
  given.isStrict = true;
  for (const RuleElement& element : rule.definition().elements)
    for (const auto& [p, q, r] : turnsOf(cornersOf(graph, element))) {
      if (!corners.empty() &&
          turnLeftInConvex(graph.linear(p), graph.linear(q), graph.linear(r), corners))
        continue;
      if (!holdsEverywhere(graph, notNegative(graph.turn(p, q, r)), given, effort)) return false;
    }
  return true;
}

/// Whether the elements have the outline of the zone, apart from sides between two of them. Then
/// they fill it: its outline goes round each place inside once, and so does the sum of theirs,
/// since positive elements go round places only forwards.
bool fillsZone(const RuleGraph& graph, const AF2Rule& rule, const GraphShape& zone) {
  if (zone.kind != ShapeKind::Poly && zone.kind != ShapeKind::Convex) return false;
  if (std::ranges::count(zone.arcs, true) > 0) return false;
  std::vector<std::pair<NodePair, NodePair>> open;
  const auto addSides = [&](const std::vector<NodePair>& corners, bool isForwards) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      std::pair side(corners[i], corners[(i + 1) % corners.size()]);
      if (!isForwards) std::swap(side.first, side.second);
      const auto opposite = std::ranges::find(open, std::pair(side.second, side.first));
      if (opposite == open.end())
        open.push_back(side);
      else
        open.erase(opposite);
    }
  };
  for (const RuleElement& element : rule.definition().elements)
    addSides(cornersOf(graph, element), true);
  addSides(zone.points, false);
  return open.empty();
}

bool isCoveredIn(RuleGraph& graph, const AF2Rule& rule, const GraphZone& zone,
                 ProofEffort& effort) {
  if (rule.definition().elements.empty()) return true;
  if (!zone.shape) return false;
  if (fillsZone(graph, rule, *zone.shape)) return true;
  Circumstances given = circumstancesOf(graph, zone);
  for (const RuleElement& element : rule.definition().elements)
    for (const auto& [p, q, r] : turnsOf(cornersOf(graph, element)))
      given.facts.push_back(graph.turn(p, q, r));
  for (const RuleElement& element : rule.definition().elements) {
    const auto claim = liesIn(graph, *zone.shape, cornersOf(graph, element));
    if (!claim || !holdsEverywhere(graph, *claim, given, effort)) return false;
  }
  return true;
}

/// A claim which implies that a condition holds (or does not hold) by more than the rounding
/// allowance of proofs. Nothing if no such claim is known.
std::optional<Claim> surely(RuleGraph& graph, Node condition, bool truth) {
  constexpr double kSpare = 1e-6;
  if (const auto constant = graph.constantValue(condition))
    return (*constant != 0) == truth ? std::optional(allOf({})) : std::nullopt;
  const Step step = graph.step(condition);
  const Node a = step.arguments[0], b = step.arguments[1];
  const auto above = [&](Node high, Node low) {
    return notNegative(graph.subtract(graph.subtract(high, low), graph.constant(kSpare)));
  };
  switch (step.op) {
    case Op::Less:
    case Op::LessEqual:
      return truth ? above(b, a) : above(a, b);
    case Op::Equal:
      return truth ? std::nullopt : std::optional(anyOf({above(a, b), above(b, a)}));
    case Op::Not:
      return surely(graph, a, !truth);
    case Op::And:
    case Op::Or: {
      const auto first = surely(graph, a, truth), second = surely(graph, b, truth);
      if ((step.op == Op::And) != truth) {  // one of the two is sufficient
        if (first && second) return anyOf({*first, *second});
        return first ? first : second;
      }
      if (!first || !second) return std::nullopt;
      return allOf({*first, *second});
    }
    default:
      return std::nullopt;
  }
}

template <class HoldsIn>
bool holdsInEachZone(const RuleSet& rules, const AF2Rule& rule, int level, const HoldsIn& holds) {
  try {
    RuleGraph graph(rules, rule, level);
    const std::vector<GraphZone> zones = graph.zones();
    for (const GraphZone& zone : zones)
      if (!holds(graph, zone)) return false;
    return true;
  } catch (const RuleGraph::Unknown&) {
    return false;
  }
}

}  // namespace

bool provesPositive(const RuleSet& rules, const AF2Rule& rule, int level, ProofEffort& effort) {
  return holdsInEachZone(rules, rule, level, [&](RuleGraph& graph, const GraphZone& zone) {
    return isPositiveIn(graph, rule, zone, effort);
  });
}

bool provesCovered(const RuleSet& rules, const AF2Rule& rule, int level, ProofEffort& effort) {
  return holdsInEachZone(rules, rule, level, [&](RuleGraph& graph, const GraphZone& zone) {
    return isCoveredIn(graph, rule, zone, effort);
  });
}

bool provesCondition(const RuleSet& rules, const AF2Rule& rule, const AF2BindingFunction& condition,
                     bool truth, int level, ProofEffort& effort,
                     std::span<const std::shared_ptr<const AF2BindingFunction>> failing) {
  constexpr MatchDomain kEverywhere{{1e-3, 1e3}, 1e3};
  try {
    RuleGraph graph(rules, rule, level, kEverywhere);
    const Node node = graph.importTruth(condition);
    if (node < 0) return false;
    Circumstances given;
    for (const auto& other : failing) {
      const Node untruth = graph.importTruth(*other);
      if (untruth < 0) continue;
      given.untruths.push_back(untruth);
      graph.addOpposites(untruth, given.facts);
    }
    const auto claim = surely(graph, node, truth);
    return claim && holdsEverywhere(graph, *claim, given, effort);
  } catch (const RuleGraph::Unknown&) {
    return false;
  }
}

}  // namespace af2::dsl
