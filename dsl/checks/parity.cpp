// P1: with `parity even`, every rule changes the number of front edges by an even number.
#include <algorithm>
#include <set>

#include "dsl/checks/checks.h"

namespace af2::dsl {
namespace {

/// The number of edges that the rule adds to the front minus the number that it consumes.
int frontChange(const RuleDefinition& rule) {
  std::set<std::pair<int, int>> edges;
  for (const RuleElement& element : rule.elements)
    for (int c = 0; c < element.size(); ++c)
      edges.insert({element.corners[static_cast<std::size_t>(c)],
                    element.corners[static_cast<std::size_t>((c + 1) % element.size())]});
  int boundary = 0, consumed = 0;
  for (const auto& [from, to] : edges) {
    if (edges.contains({to, from})) continue;
    ++boundary;
    consumed += std::any_of(rule.edges.begin(), rule.edges.end(),
                            [&](const PatternEdge& e) { return e.from == from && e.to == to; });
  }
  return boundary - 2 * consumed;
}

}  // namespace

void checkParity(const CheckedRules& rules, Findings& findings) {
  if (rules.settings.parity != Parity::Even) return;
  for (const CompiledRule& rule : rules.rules) {
    const int change = frontChange(rule.definition);
    if (change % 2 != 0)
      findings.add(rule, Code::BrokenParity,
                   rule.elementSpans.empty() ? rule.title : rule.elementSpans.front(),
                   "this rule makes even loops odd",
                   "the front changes by " + std::to_string(change) +
                       (std::abs(change) == 1 ? " edge" : " edges"),
                   "a set with `parity even` needs rules that change the front by an even number "
                   "of edges, as quadrilaterals do");
  }
}

}  // namespace af2::dsl
