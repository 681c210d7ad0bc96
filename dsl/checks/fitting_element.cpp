#include "dsl/checks/fitting_element.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "dsl/checks/checks.h"
#include "dsl/text/help.h"
#include "engine/mesh/element_shape.h"

namespace af2::dsl {
namespace {

using DirectedEdge = std::pair<int, int>;
using Cycle = std::vector<int>;

Cycle cornersOf(const RuleElement& element) {
  return {element.corners.begin(), element.corners.begin() + element.size()};
}

std::vector<DirectedEdge> edgesOf(const Cycle& cycle) {
  std::vector<DirectedEdge> edges;
  for (std::size_t i = 0; i < cycle.size(); ++i)
    edges.push_back({cycle[i], cycle[(i + 1) % cycle.size()]});
  return edges;
}

bool turnsLeft(const Cycle& cycle, const std::vector<Point2>& at) {
  std::vector<Point2> corners;
  for (const int vertex : cycle) corners.push_back(at[static_cast<std::size_t>(vertex)]);
  return turnsLeftEverywhere(corners);
}

/// Whether the elements have each directed edge at most once, have all edges of the pattern between
/// their corners in the direction of the pattern, and use every new vertex.
bool closeUp(const std::vector<Cycle>& elements, const RuleDefinition& rule) {
  std::set<DirectedEdge> edges;
  std::set<int> corners;
  for (const Cycle& element : elements)
    for (const DirectedEdge& edge : edgesOf(element)) {
      if (!edges.insert(edge).second) return false;
      corners.insert(edge.first);
    }
  for (const PatternEdge& edge : rule.edges) {
    if (edges.contains({edge.to, edge.from})) return false;
    const bool isBetween = corners.contains(edge.from) && corners.contains(edge.to);
    if (isBetween && !edges.contains({edge.from, edge.to})) return false;
  }
  const auto matched = static_cast<int>(rule.vertices.size());
  for (std::size_t i = 0; i < rule.newVertices.size(); ++i)
    if (!corners.contains(matched + static_cast<int>(i))) return false;
  return true;
}

/// Calls `visit` for each cycle of some of the vertices; each cycle begins with its smallest
/// vertex.
template <class Visit>
void forEachCycle(Cycle& cycle, std::size_t size, int vertexCount, const Visit& visit) {
  if (cycle.size() == size) return visit(cycle);
  for (int vertex = 0; vertex < vertexCount; ++vertex) {
    const bool isFirst = cycle.empty() || vertex > cycle.front();
    if (!isFirst || std::ranges::find(cycle, vertex) != cycle.end()) continue;
    cycle.push_back(vertex);
    forEachCycle(cycle, size, vertexCount, visit);
    cycle.pop_back();
  }
}

std::string namesOf(const CompiledRule& rule, const Cycle& corners) {
  std::string names;
  for (const int vertex : corners) names += (names.empty() ? "" : " ") + vertexName(rule, vertex);
  return names;
}

}  // namespace

std::string fittingElement(const CompiledRule& rule, std::size_t index) {
  const auto at = referencePositions(rule, referenceLevels(rule.definition).front());
  if (!at) return {};
  std::vector<Cycle> elements;
  for (const RuleElement& element : rule.definition.elements)
    elements.push_back(cornersOf(element));
  Cycle reversed = elements[index];
  std::ranges::reverse(reversed);
  std::rotate(reversed.begin(), std::ranges::min_element(reversed), reversed.end());
  std::vector<Cycle> fitting;
  Cycle cycle;
  forEachCycle(cycle, reversed.size(), static_cast<int>(at->size()), [&](const Cycle& one) {
    elements[index] = one;
    const auto isLeft = [&](const Cycle& element) { return turnsLeft(element, *at); };
    if (std::ranges::all_of(elements, isLeft) && closeUp(elements, rule.definition))
      fitting.push_back(one);
  });
  if (std::ranges::find(fitting, reversed) != fitting.end()) return namesOf(rule, reversed);
  return fitting.size() == 1 ? namesOf(rule, fitting.front()) : std::string();
}

std::vector<SuggestedEdit> elementEdits(const CompiledRule& rule) {
  std::vector<SuggestedEdit> edits;
  if (rule.isMirror) return edits;
  for (std::size_t i = 0; i < rule.elementSpans.size(); ++i) {
    const std::string names = fittingElement(rule, i);
    if (names.empty()) continue;
    const Remedy remedy{Remedy::Where::Whole, names};
    if (auto edit = editOf(rule.home->source, rule.elementSpans[i], remedy))
      edits.push_back(std::move(*edit));
  }
  return edits;
}

}  // namespace af2::dsl
