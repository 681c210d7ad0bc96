// G1: every new element is positive at the reference match.
#include <optional>

#include "dsl/checks/checks.h"
#include "dsl/checks/fitting_element.h"
#include "engine/base/predicates.h"
#include "engine/step/rule_scoring.h"

namespace af2::dsl {
namespace {

struct Fault {
  bool isClockwise = false;
  int vertex = -1;  ///< a corner at which the element does not turn left
};

std::optional<Fault> faultOf(const RuleElement& element, const std::vector<Point2>& points) {
  const ElementCorners corners(element, points.data());
  const std::size_t n = corners.span().size();
  std::size_t left = 0, right = 0;
  int bad = -1;
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t before = k - 1, c = k % n, after = (k + 1) % n;
    right += orientation(corners[before], corners[c], corners[after]) == Turn::Right;
    if (turnsLeftAt(corners.span(), c))
      ++left;
    else
      bad = element.corners[c];
  }
  if (left == n) return std::nullopt;
  return Fault{right == n, bad};
}

/// At the first level the element is wrong; at later levels the cause is that the pattern moves.
std::string helpFor(const CompiledRule& rule, std::size_t element, const Fault& fault, int level) {
  const int first = referenceLevels(rule.definition).front();
  if (level != first)
    return "move a vertex, or end the rule's levels before: `quality " + std::to_string(first) +
           ".." + std::to_string(level - 1) + "`";
  const std::string meant = fittingHelp(rule, element);
  if (!meant.empty()) return meant;
  const std::string below = belowBase(rule, level);
  if (!below.empty()) return below;
  return fault.isClockwise ? "name its corners counter-clockwise"
                           : "move a vertex, or take another set of corners";
}

void tell(const CompiledRule& rule, std::size_t element, const Fault& fault, int level,
          Findings& findings) {
  const bool isTriangle = rule.definition.elements[element].size() == 3;
  const std::string message = fault.isClockwise ? "this element runs clockwise"
                              : isTriangle      ? "this element has no area"
                                                : "this element is not convex";
  const std::string label = fault.isClockwise || isTriangle
                                ? ""
                                : "at the corner '" + vertexName(rule, fault.vertex) + "'";
  const bool isFirst = level == referenceLevels(rule.definition).front();
  findings.add(rule, Code::InvertedElement, rule.elementSpans[element],
               message + " at " + referenceName(rule, level), label,
               helpFor(rule, element, fault, level), {},
               isFirst ? elementEdits(rule) : std::vector<SuggestedEdit>());
}

}  // namespace

void checkOrientation(const CheckedRules& rules, Findings& findings) {
  for (const CompiledRule& rule : rules.rules) {
    std::vector<bool> isTold(rule.definition.elements.size());
    for (const int level : referenceLevels(rule.definition)) {
      const auto points = referencePositions(rule, level);
      if (!points) continue;
      for (std::size_t i = 0; i < isTold.size(); ++i) {
        if (isTold[i]) continue;
        const auto fault = faultOf(rule.definition.elements[i], *points);
        if (!fault) continue;
        isTold[i] = true;
        tell(rule, i, *fault, level, findings);
      }
    }
  }
}

}  // namespace af2::dsl
