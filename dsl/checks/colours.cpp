// P2: with `parity even`, can the vertices of a rule have the colours that its loops need?
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "dsl/checks/checks.h"

namespace af2::dsl {
namespace {

using Edges = std::vector<std::pair<int, int>>;

/// The edges of the pattern, then those of the elements.
Edges edgesOf(const RuleDefinition& rule) {
  Edges edges;
  for (const PatternEdge& e : rule.edges) edges.emplace_back(e.from, e.to);
  for (const RuleElement& element : rule.elements)
    for (int c = 0; c < element.size(); ++c)
      edges.emplace_back(element.corners[static_cast<std::size_t>(c)],
                         element.corners[static_cast<std::size_t>((c + 1) % element.size())]);
  return edges;
}

/// An edge whose ends must have the same colour, if the others join unlike colours.
std::optional<std::size_t> clashingEdge(const Edges& edges, std::size_t vertices) {
  std::vector<int> colour(vertices, -1);
  for (std::size_t start = 0; start < vertices; ++start) {
    if (colour[start] >= 0) continue;
    std::vector<std::size_t> open{start};
    colour[start] = 0;
    while (!open.empty()) {
      const std::size_t v = open.back();
      open.pop_back();
      for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto [from, to] = edges[e];
        const bool isFrom = static_cast<std::size_t>(from) == v;
        if (!isFrom && static_cast<std::size_t>(to) != v) continue;
        const auto other = static_cast<std::size_t>(isFrom ? to : from);
        if (colour[other] == colour[v]) return e;
        if (colour[other] >= 0) continue;
        colour[other] = 1 - colour[v];
        open.push_back(other);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

void checkColours(const CheckedRules& rules, Findings& findings) {
  if (rules.settings.parity != Parity::Even) return;
  for (const CompiledRule& rule : rules.rules) {
    const RuleDefinition& definition = rule.definition;
    const Edges edges = edgesOf(definition);
    const auto clash =
        clashingEdge(edges, definition.vertices.size() + definition.newVertices.size());
    if (!clash) continue;
    const auto [from, to] = edges[*clash];
    findings.add(
        rule, Code::ClashingColours,
        rule.elementSpans.empty() ? rule.title : rule.elementSpans.front(),
        "this rule never applies: its edges join vertices of like colours",
        "from " + vertexName(rule, from) + " to " + vertexName(rule, to) +
            " there are ways of odd and of even length",
        "with `parity even` the vertices of a loop have two colours in turn, and every edge "
        "joins unlike ones; triangles and closed chains of odd length cannot occur");
  }
}

}  // namespace af2::dsl
