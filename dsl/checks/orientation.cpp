// G1: every new element is positive at the reference match.
#include "dsl/checks/checks.h"
#include "dsl/checks/fitting_element.h"
#include "engine/predicates.h"

namespace af2::dsl {

void checkOrientation(const CheckedRules& rules, Findings& findings) {
  for (const CompiledRule& rule : rules.rules) {
    const auto points = referencePositions(rule);
    if (!points) continue;
    for (std::size_t i = 0; i < rule.definition.elements.size(); ++i) {
      const RuleElement& element = rule.definition.elements[i];
      const int n = element.size();
      int left = 0, right = 0, bad = -1;
      for (int c = 0; c < n; ++c) {
        const auto at = [&](int k) {
          return (
              *points)[static_cast<std::size_t>(element.corners[static_cast<std::size_t>(k % n)])];
        };
        const Turn turn = orientation(at(c), at(c + 1), at(c + 2));
        left += turn == Turn::Left;
        right += turn == Turn::Right;
        if (turn != Turn::Left) bad = element.corners[static_cast<std::size_t>((c + 1) % n)];
      }
      if (left == n) continue;
      const bool isClockwise = right == n;
      const std::string meant = fittingElement(rule, i);
      findings.add(rule, Severity::Error, "G1", rule.elementSpans[i],
                   isClockwise ? "this element runs clockwise at the reference match"
                   : n == 3    ? "this element has no area at the reference match"
                               : "this element is not convex at the reference match",
                   isClockwise ? ""
                   : n == 4    ? "at the corner '" + vertexName(rule, bad) + "'"
                               : "",
                   !meant.empty() ? "did you mean `" + meant + "`?"
                   : isClockwise  ? "name its corners counter-clockwise"
                                  : "move a vertex, or take another set of corners",
                   {}, elementEdits(rule));
    }
  }
}

}  // namespace af2::dsl
