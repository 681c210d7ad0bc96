#include "engine/rule/rule.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/base/error.h"
#include "engine/base/turn.h"
#include "engine/rule/rule_at_match.h"

namespace af2 {
namespace {

using Edge = std::pair<int, int>;

[[noreturn]] void fail(const RuleDefinition& rule, const std::string& what) {
  throw InputError("rule \"" + rule.name + "\": " + what);
}

std::string vertexName(const RuleDefinition& rule, int vertex) {
  const auto matched = static_cast<int>(rule.vertices.size());
  const auto index = static_cast<std::size_t>(vertex < matched ? vertex : vertex - matched);
  if (vertex < matched) return rule.vertices[index].name;
  return index < rule.newVertexNames.size() ? rule.newVertexNames[index]
                                            : "new " + std::to_string(index + 1);
}

std::string edgeName(const RuleDefinition& rule, Edge edge) {
  return vertexName(rule, edge.first) + "->" + vertexName(rule, edge.second);
}

/// Names serve messages and pictures: no two vertices may have the same one.
void checkNames(const RuleDefinition& rule) {
  if (rule.newVertexNames.size() > rule.newVertices.size())
    fail(rule, "names more new vertices than it has");
  std::set<std::string> names;
  const auto add = [&](const std::string& name) {
    if (!name.empty() && !names.insert(name).second)
      fail(rule, "has two vertices of the name " + name);
  };
  for (const PatternVertex& v : rule.vertices) add(v.name);
  for (const std::string& name : rule.newVertexNames) add(name);
}

void checkVertices(const RuleDefinition& rule) {
  const std::size_t total = rule.vertices.size() + rule.newVertices.size();
  if (rule.vertices.size() < 2) fail(rule, "needs the ends a, b of the base edge");
  if (total > AF2Rule::kMaxVertices)
    fail(rule, "has " + std::to_string(total) + " vertices; at most " +
                   std::to_string(AF2Rule::kMaxVertices) + " are possible");
  for (const auto& transform : rule.newVertices)
    if (!transform) fail(rule, "a new vertex has no position");
  checkNames(rule);
  if (!rule.zone) fail(rule, "has no free zone");
  if (rule.firstLevel < 1 || (rule.lastLevel && *rule.lastLevel < rule.firstLevel))
    fail(rule, "its quality levels are empty");
}

void checkPattern(const RuleDefinition& rule) {
  if (rule.edges.empty() || rule.edges[0].from != 0 || rule.edges[0].to != 1)
    fail(rule, "the first pattern edge must be the base a->b");
  std::set<int> starts, ends;
  const auto matched = static_cast<int>(rule.vertices.size());
  for (const PatternEdge& edge : rule.edges) {
    for (int v : {edge.from, edge.to})
      if (v < 0 || v >= matched) fail(rule, "a pattern edge uses a vertex that is not matched");
    if (edge.from == edge.to) fail(rule, "a pattern edge begins and ends at the same vertex");
    if (!starts.insert(edge.from).second || !ends.insert(edge.to).second)
      fail(rule, "the chains of the pattern branch at " + edgeName(rule, {edge.from, edge.to}));
  }
}

/// The directed edges of the new elements.
std::set<Edge> elementEdges(const RuleDefinition& rule) {
  if (rule.elements.empty()) fail(rule, "makes no element");
  if (rule.elements.size() > AF2Rule::kMaxElements)
    fail(rule, "makes more than " + std::to_string(AF2Rule::kMaxElements) + " elements");
  const auto total = static_cast<int>(rule.vertices.size() + rule.newVertices.size());
  std::set<Edge> edges;
  for (const RuleElement& element : rule.elements) {
    for (int i = 0; i < element.size(); ++i) {
      const int from = element.corners[static_cast<std::size_t>(i)];
      const int to = element.corners[static_cast<std::size_t>((i + 1) % element.size())];
      if (from < 0 || from >= total) fail(rule, "an element uses an unknown vertex");
      if (from == to) fail(rule, "an element repeats vertex " + vertexName(rule, from));
      if (!edges.insert({from, to}).second)
        fail(rule,
             "two elements use the edge " + edgeName(rule, {from, to}) + " in the same direction");
    }
  }
  return edges;
}

std::set<Edge> boundaryOf(const std::set<Edge>& edges) {
  std::set<Edge> boundary;
  for (const Edge& e : edges)
    if (!edges.contains({e.second, e.first})) boundary.insert(e);
  return boundary;
}

/// Positions of all vertices at the reference match; new vertices without a position there are put
/// above the middle of the base.
std::vector<Point2> referencePositions(const RuleDefinition& rule) {
  const RuleAtMatch match = RuleAtMatch::atReference(rule, rule.firstLevel);
  std::vector<Point2> points = match.vertices();
  for (const auto& place : newVerticesAt(rule, match.binding()))
    points.push_back(place.value_or(Point2{0.5, 0.5}));
  return points;
}

/// Where elements touch in a single vertex, several boundary edges leave it. The walk continues
/// with the first of them counter-clockwise from the direction it came from: the unmeshed region
/// lies to the right of the walk.
int nextOnWalk(const std::set<Edge>& unused, const std::vector<Point2>& points, Edge last) {
  int best = -1;
  double bestSweep = 0;
  for (const Edge& e : unused) {
    if (e.first != last.second) continue;
    const auto at = [&](int v) { return points[static_cast<std::size_t>(v)]; };
    const double angle =
        turnBetween(at(last.first) - at(last.second), at(e.second) - at(last.second));
    if (best < 0 || angle < bestSweep) best = e.second, bestSweep = angle;
  }
  return best;
}

/// The boundary walk around the new elements, from b to a, without its ends, reversed.
std::vector<std::int8_t> replacementOf(const RuleDefinition& rule, const std::set<Edge>& boundary) {
  if (!boundary.contains({0, 1})) fail(rule, "does not consume its base edge a->b");
  const std::vector<Point2> points = referencePositions(rule);
  std::set<Edge> unused = boundary;
  unused.erase({0, 1});
  std::vector<std::int8_t> walk;
  Edge last{0, 1};
  while (!unused.empty()) {
    const int next = nextOnWalk(unused, points, last);
    if (next < 0) break;
    last = {last.second, next};
    unused.erase(last);
    walk.push_back(static_cast<std::int8_t>(next));
  }
  if (!unused.empty() || walk.empty() || walk.back() != 0)
    fail(rule, "the boundary of its elements is not one closed walk through a->b");
  walk.pop_back();
  std::reverse(walk.begin(), walk.end());
  return walk;
}

/// The vertex between the two edges of a weld, one of which is the base.
int middleOf(const RuleDefinition& rule) {
  const auto has = [&](int from, int to) {
    return std::ranges::any_of(rule.edges,
                               [&](const PatternEdge& e) { return e.from == from && e.to == to; });
  };
  const auto [from, into, place] = *rule.weld;
  for (const int middle : {0, 1})
    if ((has(from, middle) && has(middle, into)) || (has(into, middle) && has(middle, from)))
      return middle;
  fail(rule, "welds vertices that are not the far ends of the base edge and the next one");
}

void checkActs(const RuleDefinition& rule) {
  if (!rule.elements.empty())
    fail(rule, "makes elements; a rule that welds or has a path makes none");
  if (rule.weld && rule.path) fail(rule, "welds and has a path");
  if (rule.path && (rule.vertices.size() != 3 || !rule.newVertices.empty()))
    fail(rule, "has a path, so it takes a, b and one other vertex");
  if (rule.weld && (rule.newVertices.size() != 1 || !rule.weld->place))
    fail(rule, "welds, so it has one new position");
}

}  // namespace

AF2Rule::AF2Rule(RuleDefinition definition) : definition_(std::move(definition)) {
  checkVertices(definition_);
  checkPattern(definition_);
  if (!makesElements()) {
    checkActs(definition_);
    if (!definition_.weld) return;
    weldMiddle_ = middleOf(definition_);
    for (const PatternEdge& edge : definition_.edges)
      if (edge.from == weldMiddle_ || edge.to == weldMiddle_) consumed_.push_back(edge);
    return;
  }
  const std::set<Edge> boundary = boundaryOf(elementEdges(definition_));

  for (const PatternEdge& edge : definition_.edges) {
    if (boundary.contains({edge.to, edge.from}))
      fail(definition_, "its elements lie on the wrong side of the front edge " +
                            edgeName(definition_, {edge.from, edge.to}));
    if (boundary.contains({edge.from, edge.to})) consumed_.push_back(edge);
  }
  const auto isConsumed = [&](const Edge& e) {
    return std::any_of(consumed_.begin(), consumed_.end(),
                       [&](const PatternEdge& c) { return c.from == e.first && c.to == e.second; });
  };
  for (const Edge& e : boundary)
    if (!isConsumed(e)) new_.push_back({e.second, e.first, std::nullopt});
  replacement_ = replacementOf(definition_, boundary);
}

}  // namespace af2
