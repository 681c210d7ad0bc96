// T2: chains, vertices and elements are valid.
#include <algorithm>
#include <set>

#include "dsl/checks/checks.h"

namespace af2::dsl {
namespace {

/// Whether no element repeats a vertex; reports one that does.
bool checkRepetition(const CompiledRule& rule, std::size_t i, Findings& findings) {
  const RuleElement& element = rule.definition.elements[i];
  std::set<int> seen;
  for (int c = 0; c < element.size(); ++c) {
    const int vertex = element.corners[static_cast<std::size_t>(c)];
    if (!seen.insert(vertex).second) {
      findings.add(rule, Code::MalformedPattern, rule.elementSpans[i],
                   "this element uses the vertex '" + vertexName(rule, vertex) + "' twice", "",
                   "an element has three or four different corners");
      return false;
    }
  }
  return true;
}

bool consumesBase(const RuleDefinition& rule) {
  const auto uses = [&](int from, int to) {
    return std::any_of(rule.elements.begin(), rule.elements.end(), [&](const RuleElement& e) {
      for (int c = 0; c < e.size(); ++c)
        if (e.corners[static_cast<std::size_t>(c)] == from &&
            e.corners[static_cast<std::size_t>((c + 1) % e.size())] == to)
          return true;
      return false;
    });
  };
  return uses(0, 1) || uses(1, 0);  // the wrong direction is a different fault
}

void checkNewVertices(const CompiledRule& rule, Findings& findings) {
  std::set<int> used;
  for (const RuleElement& element : rule.definition.elements)
    used.insert(element.corners.begin(), element.corners.end());
  const auto matched = static_cast<int>(rule.definition.vertices.size());
  for (std::size_t i = 0; i < rule.definition.newVertices.size(); ++i) {
    const int vertex = matched + static_cast<int>(i);
    if (!used.contains(vertex))
      findings.add(rule, Code::MalformedPattern, rule.vertexSpans[static_cast<std::size_t>(vertex)],
                   "no element uses the new vertex '" + vertexName(rule, vertex) + "'", "",
                   "use it in an element, or make it a `let`");
  }
}

void checkCount(const CompiledRule& rule, Findings& findings) {
  if (rule.definition.elements.size() > static_cast<std::size_t>(AF2Rule::kMaxElements))
    findings.add(rule, Code::MalformedPattern, rule.elementSpans.back(),
                 "this rule makes " + std::to_string(rule.definition.elements.size()) + " elements",
                 "", "at most " + std::to_string(AF2Rule::kMaxElements) + " are possible");
}

}  // namespace

void checkPattern(const CheckedRules& rules, Findings& findings) {
  for (const CompiledRule& rule : rules.rules) {
    bool isRight = !rule.definition.elements.empty();
    for (std::size_t i = 0; i < rule.definition.elements.size(); ++i)
      isRight = checkRepetition(rule, i, findings) && isRight;
    if (isRight) checkNewVertices(rule, findings);
    checkCount(rule, findings);
    if (!rule.definition.elements.empty() && !consumesBase(rule.definition))
      findings.add(rule, Code::MalformedPattern, rule.elementSpans.front(),
                   "no element consumes the base edge a -> b", "",
                   "every rule needs an element with a and b as neighbouring corners");
  }
}

}  // namespace af2::dsl
