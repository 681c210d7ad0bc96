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

bool haveSameCorners(Cycle one, Cycle other) {
  std::ranges::sort(one);
  std::ranges::sort(other);
  return one == other;
}

/// How many corners of one element the other does not have.
std::size_t cornersReplaced(const Cycle& written, const Cycle& other) {
  return static_cast<std::size_t>(std::ranges::count_if(
      written, [&](int corner) { return std::ranges::find(other, corner) == other.end(); }));
}

/// Whether an element cannot stay as it is, whatever becomes of the others: it does not turn left,
/// or has an edge that another element or, the other way round, the front has.
bool isWrongByItself(const std::vector<Cycle>& elements, std::size_t index,
                     const RuleDefinition& rule, const std::vector<Point2>& at) {
  if (!turnsLeft(elements[index], at)) return true;
  for (const DirectedEdge& edge : edgesOf(elements[index])) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const auto others = edgesOf(elements[i]);
      if (i != index && std::ranges::find(others, edge) != others.end()) return true;
    }
    const auto runsAgainst = [&](const PatternEdge& front) {
      return front.from == edge.second && front.to == edge.first;
    };
    if (std::ranges::any_of(rule.edges, runsAgainst)) return true;
  }
  return false;
}

/// The cycles in place of one element with which all is right.
std::vector<Cycle> fittingCycles(std::vector<Cycle> elements, std::size_t index,
                                 const RuleDefinition& rule, const std::vector<Point2>& at) {
  const std::size_t size = elements[index].size();
  std::vector<Cycle> fitting;
  Cycle cycle;
  forEachCycle(cycle, size, static_cast<int>(at.size()), [&](const Cycle& one) {
    elements[index] = one;
    const auto isLeft = [&](const Cycle& element) { return turnsLeft(element, at); };
    if (std::ranges::all_of(elements, isLeft) && closeUp(elements, rule)) fitting.push_back(one);
  });
  return fitting;
}

}  // namespace

FittingElement fittingElement(const CompiledRule& rule, std::size_t index) {
  const auto at = referencePositions(rule, referenceLevels(rule.definition).front());
  if (!at) return {};
  std::vector<Cycle> elements;
  for (const RuleElement& element : rule.definition.elements)
    elements.push_back(cornersOf(element));
  const Cycle& written = elements[index];
  const std::vector<Cycle> fitting = fittingCycles(elements, index, rule.definition, *at);
  const auto reordered = std::ranges::find_if(
      fitting, [&](const Cycle& one) { return haveSameCorners(one, written); });
  if (reordered != fitting.end()) return {namesOf(rule, *reordered), true};
  const bool isClear = fitting.size() == 1 && cornersReplaced(written, fitting.front()) == 1 &&
                       isWrongByItself(elements, index, rule.definition, *at);
  return isClear ? FittingElement{namesOf(rule, fitting.front()), false} : FittingElement{};
}

std::string fittingHelp(const CompiledRule& rule, std::size_t index, const std::string& place) {
  const FittingElement fitting = fittingElement(rule, index);
  if (fitting.corners.empty()) return {};
  const std::string element = "`" + fitting.corners + "`" + place;
  return fitting.isReordered
             ? "did you mean " + element + "?"
             : "only " + element + " closes up with the front and the other elements";
}

std::vector<SuggestedEdit> elementEdits(const CompiledRule& rule) {
  std::vector<SuggestedEdit> edits;
  if (rule.isMirror) return edits;
  for (std::size_t i = 0; i < rule.elementSpans.size(); ++i) {
    const std::string names = fittingElement(rule, i).corners;
    if (names.empty()) continue;
    const Remedy remedy{Remedy::Where::Whole, names};
    if (auto edit = editOf(rule.home->source, rule.elementSpans[i], remedy))
      edits.push_back(std::move(*edit));
  }
  return edits;
}

}  // namespace af2::dsl
