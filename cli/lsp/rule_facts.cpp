#include "cli/lsp/rule_facts.h"

#include <algorithm>

namespace af2::lsp {
namespace {

std::string nameOf(const AF2Rule& rule, int vertex) {
  const auto index = static_cast<std::size_t>(vertex);
  const RuleDefinition& d = rule.definition();
  return index < d.vertices.size() ? d.vertices[index].name
                                   : d.newVertexNames[index - d.vertices.size()];
}

/// Joins edges that follow one another into chains.
std::vector<std::string> chainsOf(const AF2Rule& rule, std::vector<PatternEdge> edges) {
  std::vector<std::string> chains;
  while (!edges.empty()) {
    // Starts with an edge that has no predecessor, if there is one.
    auto first = std::ranges::find_if(edges, [&](const PatternEdge& e) {
      return std::ranges::find(edges, e.from, &PatternEdge::to) == edges.end();
    });
    if (first == edges.end()) first = edges.begin();
    std::string chain = nameOf(rule, first->from);
    for (auto at = first; at != edges.end();) {
      const int to = at->to;
      chain += " -> " + nameOf(rule, to);
      edges.erase(at);
      at = std::ranges::find(edges, to, &PatternEdge::from);
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

bool isSameEdge(const PatternEdge& a, const PatternEdge& b) {
  return a.from == b.from && a.to == b.to;
}

}  // namespace

RuleFacts factsOf(const AF2Rule& rule) {
  RuleFacts facts;
  const RuleDefinition& d = rule.definition();
  std::vector<PatternEdge> kept;
  for (const PatternEdge& edge : d.edges) {
    const bool isConsumed = std::ranges::any_of(
        rule.consumedEdges(), [&](const PatternEdge& e) { return isSameEdge(e, edge); });
    if (!isConsumed) kept.push_back(edge);
  }
  facts.consumed = chainsOf(rule, rule.consumedEdges());
  facts.kept = chainsOf(rule, std::move(kept));
  facts.made = chainsOf(rule, rule.newEdges());
  facts.newVertices = d.newVertexNames;
  for (const RuleElement& element : d.elements)
    ++(element.size() == 3 ? facts.triangles : facts.quads);
  return facts;
}

std::string joined(const std::vector<std::string>& parts, const std::string& none) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text.empty() ? none : text;
}

const AF2Rule* findSound(const RuleSet& rules, const std::string& title) {
  const auto found = std::ranges::find(rules.rules(), title, &AF2Rule::name);
  return found == rules.rules().end() ? nullptr : &*found;
}

}  // namespace af2::lsp
