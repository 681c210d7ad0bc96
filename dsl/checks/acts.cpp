// W1, W2: do welds and paths shorten or divide loops, so that meshing ends?
#include <algorithm>

#include "dsl/checks/checks.h"

namespace af2::dsl {
namespace {

bool hasEdge(const RuleDefinition& rule, int from, int to) {
  return std::ranges::any_of(rule.edges,
                             [&](const PatternEdge& e) { return e.from == from && e.to == to; });
}

/// Whether the two vertices are the far ends of the base edge and a neighbour of it.
bool areFarEnds(const RuleDefinition& rule, int p, int q) {
  return std::ranges::any_of(std::array{0, 1}, [&](int middle) {
    return (hasEdge(rule, p, middle) && hasEdge(rule, middle, q)) ||
           (hasEdge(rule, q, middle) && hasEdge(rule, middle, p));
  });
}

void checkWeld(const CompiledRule& rule, Findings& findings) {
  const auto& [from, into, place] = *rule.definition.weld;
  if (from != into && areFarEnds(rule.definition, from, into)) return;
  const bool areNeighbours =
      hasEdge(rule.definition, from, into) || hasEdge(rule.definition, into, from);
  findings.add(
      rule, Code::WeldOperands, *rule.actSpan,
      from == into    ? "a vertex cannot be welded into itself"
      : areNeighbours ? "neighbouring vertices cannot be welded: the edge between them "
                        "would have no length"
                      : "these vertices are not the far ends of two neighbouring edges",
      "",
      "the base edge and the next one close like a seam: `front a -> b -> c; weld c into a "
      "at mid(a, c);`");
}

void checkAct(const CheckedRules& rules, const CompiledRule& rule, Findings& findings) {
  const RuleDefinition& definition = rule.definition;
  if (!definition.elements.empty())
    findings.add(rule, Code::UnendingAct, *rule.actSpan,
                 "a rule that welds or has a path makes no elements", "",
                 "write two rules: one for the elements, one for the act");
  if (definition.weld && definition.path)
    findings.add(rule, Code::UnendingAct, *rule.actSpan, "a rule either welds or has a path", "",
                 "write two rules");
  if (definition.weld && definition.newVertices.size() > 1)
    findings.add(rule, Code::UnendingAct, *rule.actSpan, "a rule that welds makes no vertices", "",
                 "remove `new`, or use `let` for a place");
  if (definition.path && rules.settings.parity != Parity::Even)
    findings.add(rule, Code::UnendingAct, *rule.actSpan,
                 "a path needs `parity even`: only then is it known that the parts can be filled",
                 "", "add `parity even;` to the rule set");
  if (definition.path && (definition.vertices.size() > 3 || !definition.newVertices.empty()))
    findings.add(rule, Code::UnendingAct, *rule.actSpan,
                 "a rule with a path has no vertices but a, b and the far one", "",
                 "write conditions with `require`");
}

}  // namespace

void checkActs(const CheckedRules& rules, Findings& findings) {
  for (const CompiledRule& rule : rules.rules) {
    if (!rule.actSpan) continue;
    if (rule.definition.weld) checkWeld(rule, findings);
    checkAct(rules, rule, findings);
  }
}

}  // namespace af2::dsl
