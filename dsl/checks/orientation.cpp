// G1: every new element is positive at the reference match.
#include <optional>

#include "dsl/checks/checks.h"
#include "dsl/checks/fitting_element.h"
#include "engine/base/predicates.h"

namespace af2::dsl {
namespace {

struct Fault {
  bool isClockwise = false;
  int vertex = -1;  ///< where it does not turn left
};

std::optional<Fault> faultOf(const RuleElement& element, const std::vector<Point2>& points) {
  const int n = element.size();
  const auto vertexAt = [&](int k) { return element.corners[static_cast<std::size_t>(k % n)]; };
  const auto at = [&](int k) { return points[static_cast<std::size_t>(vertexAt(k))]; };
  int left = 0, right = 0, bad = -1;
  for (int c = 0; c < n; ++c) {
    const Turn turn = orientation(at(c), at(c + 1), at(c + 2));
    left += turn == Turn::Left;
    right += turn == Turn::Right;
    if (turn != Turn::Left) bad = vertexAt(c + 1);
  }
  if (left == n) return std::nullopt;
  return Fault{right == n, bad};
}

/// Elements are written for what the first level shows; at later ones it is the pattern that moved.
std::string helpFor(const CompiledRule& rule, std::size_t element, const Fault& fault, int level) {
  const int first = referenceLevels(rule.definition).front();
  if (level != first)
    return "move a vertex, or end the rule's levels before: `quality " + std::to_string(first) +
           ".." + std::to_string(level - 1) + "`";
  const std::string meant = fittingElement(rule, element);
  if (!meant.empty()) return "did you mean `" + meant + "`?";
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
  findings.add(rule, Severity::Error, "G1", rule.elementSpans[element],
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
