// T1: the elements and the pattern fit together.
#include <algorithm>
#include <map>
#include <set>

#include "dsl/checks/checks.h"
#include "dsl/checks/fitting_element.h"

namespace af2::dsl {
namespace {

using Edge = std::pair<int, int>;

std::string edgeName(const CompiledRule& rule, Edge e) {
  return vertexName(rule, e.first) + "->" + vertexName(rule, e.second);
}

/// Suggests the corrected element if there is a unique one, otherwise gives the general advice.
std::string wayOut(const CompiledRule& rule, std::string otherwise) {
  for (std::size_t i = 0; i < rule.definition.elements.size(); ++i) {
    const std::string meant = fittingHelp(rule, i, " as element " + std::to_string(i + 1));
    if (!meant.empty()) return meant;
  }
  return otherwise;
}

std::vector<Edge> edgesOf(const RuleElement& element) {
  std::vector<Edge> edges;
  for (int c = 0; c < element.size(); ++c)
    edges.emplace_back(element.corners[static_cast<std::size_t>(c)],
                       element.corners[static_cast<std::size_t>((c + 1) % element.size())]);
  return edges;
}

/// Collects each directed edge with its element. If two elements have the same edge, reports it and
/// returns false.
bool collectEdges(const CompiledRule& rule, std::map<Edge, std::size_t>& owner,
                  Findings& findings) {
  bool isRight = true;
  for (std::size_t i = 0; i < rule.definition.elements.size(); ++i)
    for (const Edge& e : edgesOf(rule.definition.elements[i])) {
      const auto [known, isNew] = owner.emplace(e, i);
      if (isNew) continue;
      isRight = false;
      const bool isSame = known->second == i;
      findings.add(
          rule, Code::OpenTopology, rule.elementSpans[i],
          "the new elements do not fit together: " + edgeName(rule, e) +
              (isSame ? " occurs twice in one element" : " occurs in two of them"),
          "", "neighbouring elements use their common edge in opposite directions",
          {{"the other element", placeOf(rule.home->source, rule.elementSpans[known->second])}},
          elementEdits(rule));
    }
  return isRight;
}

/// Each edge of the pattern is on the boundary of the elements, in its own direction, or apart from
/// the elements.
bool checkPatternEdges(const CompiledRule& rule, const std::map<Edge, std::size_t>& owner,
                       Findings& findings) {
  std::set<int> corners;
  for (const auto& [e, i] : owner) corners.insert(e.first);
  bool isRight = true;
  for (std::size_t k = 0; k < rule.definition.edges.size(); ++k) {
    const PatternEdge& edge = rule.definition.edges[k];
    const Edge e{edge.from, edge.to}, back{edge.to, edge.from};
    const auto against = owner.find(back);
    if (against != owner.end()) {
      isRight = false;
      findings.add(rule, Code::OpenTopology, rule.elementSpans[against->second],
                   "this element lies on the wrong side of the front edge " + edgeName(rule, e),
                   "it has " + edgeName(rule, back),
                   "corners run counter-clockwise, so that the element has " + edgeName(rule, e),
                   {{"the front edge", placeOf(rule.home->source, rule.edgeSpans[k])}},
                   elementEdits(rule));
    } else if (!owner.contains(e) && corners.contains(e.first) && corners.contains(e.second)) {
      isRight = false;
      const auto after = std::find_if(owner.begin(), owner.end(),
                                      [&](const auto& o) { return o.first.first == e.second; });
      findings.add(rule, Code::OpenTopology,
                   cover(rule.elementSpans.front(), rule.elementSpans[after->second]),
                   "the new elements do not close up with the front",
                   edgeName(rule, e) + " is left over between their corners",
                   wayOut(rule, "add or correct the element that has " + edgeName(rule, e) +
                                    ", or leave this edge out of the pattern"),
                   {{"the front edge", placeOf(rule.home->source, rule.edgeSpans[k])}},
                   elementEdits(rule));
    }
  }
  return isRight;
}

/// Number of connected groups of elements; a common vertex connects.
std::size_t groups(const RuleDefinition& rule) {
  std::vector<std::set<int>> parts;
  for (const RuleElement& element : rule.elements) {
    std::set<int> joined(element.corners.begin(), element.corners.begin() + element.size());
    std::vector<std::set<int>> rest;
    for (std::set<int>& part : parts) {
      const bool touches =
          std::any_of(part.begin(), part.end(), [&](int v) { return joined.contains(v); });
      if (touches)
        joined.insert(part.begin(), part.end());
      else
        rest.push_back(std::move(part));
    }
    rest.push_back(std::move(joined));
    parts = std::move(rest);
  }
  return parts.size();
}

/// The boundary of the union is one closed walk if the union is a disc, or discs that touch at
/// vertices; then corners - edges + elements = 1.
void checkDisc(const CompiledRule& rule, const std::map<Edge, std::size_t>& owner,
               Findings& findings) {
  if (groups(rule.definition) > 1) {
    findings.add(rule, Code::OpenTopology, rule.elementSpans.back(),
                 "the new elements are not connected", "",
                 "all elements of a rule share vertices with each other", {}, elementEdits(rule));
    return;
  }
  std::set<int> corners;
  std::set<Edge> edges;
  for (const auto& [e, i] : owner) {
    corners.insert(e.first);
    edges.insert({std::min(e.first, e.second), std::max(e.first, e.second)});
  }
  const auto euler = static_cast<long>(corners.size()) - static_cast<long>(edges.size()) +
                     static_cast<long>(rule.definition.elements.size());
  if (euler != 1)
    findings.add(rule, Code::OpenTopology, rule.elementSpans.back(),
                 "the new elements leave a hole or overlap", "",
                 "together they must fill one region without holes", {}, elementEdits(rule));
}

}  // namespace

void checkTopology(const CheckedRules& rules, Findings& findings) {
  for (const CompiledRule& rule : rules.rules) {
    if (rule.definition.elements.empty()) continue;
    std::map<Edge, std::size_t> owner;
    if (collectEdges(rule, owner, findings) && checkPatternEdges(rule, owner, findings))
      checkDisc(rule, owner, findings);
  }
}

}  // namespace af2::dsl
