#include "dsl/netgen/rls_rule_text.h"

#include <algorithm>
#include <array>
#include <set>

#include "dsl/netgen/rls_expression.h"

namespace af2::dsl {
namespace {

const ExactForm kUsualForm{1, 0, 1};

std::string joined(const std::vector<std::string>& parts, const std::string& between = ", ") {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : between) + part;
  return text;
}

std::string formText(const ExactForm& form) {
  if (form[0] == form[2] && form[1] == 0) return numberText(form[0]);
  return "(" + numberText(form[0]) + ", " + numberText(form[1]) + ", " + numberText(form[2]) + ")";
}

ExactMap vertexMap(std::size_t vertex, std::size_t count) {
  ExactMap map;
  for (auto& row : map.weights) row.assign(2 * count, 0);
  if (vertex > 0) map.weights[0][2 * vertex] = 1;
  if (vertex > 1) map.weights[1][2 * vertex + 1] = 1;
  return map;
}

class Writer {
 public:
  Writer(const ClassicRule& rule, const std::string& title)
      : rule_(rule), names_(vertexNames(rule)) {
    text_.title = title;
    text_.quality = rule.quality;
    text_.remarks = rule.remarks;
    for (std::size_t v = 0; v < rule.matched.size(); ++v)
      points_.push_back({names_[v], vertexMap(v, rule.matched.size())});
  }

  RuleText write() {
    writeFront();
    writePlaces();
    writeSlopes();
    writeOrientations();
    writeNewVertices();
    writeZone();
    writeElements();
    return std::move(text_);
  }

 private:
  const std::string& name(int vertex) const { return names_[static_cast<std::size_t>(vertex)]; }

  void clause(const std::string& keyword, const std::vector<std::string>& parts) {
    if (!parts.empty()) text_.clauses.push_back(keyword + " " + joined(parts) + ";");
  }

  /// A chain begins at a vertex without an incoming edge; a closed chain may begin anywhere.
  void writeFront() {
    if (rule_.edges.size() == 1) return;
    std::vector<bool> isUsed(rule_.edges.size());
    std::vector<std::string> chains;
    for (std::size_t i = 0; i < rule_.edges.size(); ++i)
      if (!isUsed[i]) chains.push_back(chain(start(i), isUsed));
    clause("front", chains);
  }

  std::size_t start(std::size_t edge) const {
    std::size_t first = edge;
    for (std::size_t steps = 0; steps < rule_.edges.size(); ++steps) {
      const auto before =
          std::ranges::find(rule_.edges, rule_.edges[first].from, &ClassicRule::Edge::to);
      if (before == rule_.edges.end()) return first;
      first = static_cast<std::size_t>(before - rule_.edges.begin());
      if (first == edge) return edge;
    }
    return first;
  }

  std::string chain(std::size_t edge, std::vector<bool>& isUsed) const {
    std::string text = name(rule_.edges[edge].from);
    while (!isUsed[edge]) {
      isUsed[edge] = true;
      text += " -> " + name(rule_.edges[edge].to);
      const auto after =
          std::ranges::find(rule_.edges, rule_.edges[edge].to, &ClassicRule::Edge::from);
      if (after == rule_.edges.end()) break;
      edge = static_cast<std::size_t>(after - rule_.edges.begin());
    }
    return text;
  }

  void writePlaces() {
    std::vector<std::string> places;
    for (std::size_t v = 2; v < rule_.matched.size(); ++v) {
      const ClassicRule::Vertex& vertex = rule_.matched[v];
      places.push_back(names_[v] + " (" + numberText(vertex.x) + ", " + numberText(vertex.y) + ")" +
                       (vertex.form == kUsualForm ? "" : " ~ " + formText(vertex.form)));
    }
    clause("at", places);
  }

  void writeSlopes() {
    for (const ClassicRule::Edge& edge : rule_.edges)
      if (edge.slope)
        clause("slope", {name(edge.from) + " -> " + name(edge.to) + " ~ " + formText(*edge.slope)});
  }

  void writeOrientations() {
    std::set<std::array<int, 3>> triples;
    for (std::array<int, 3> t : rule_.orientations) {
      std::ranges::rotate(t, std::ranges::min_element(t));
      triples.insert(t);
    }
    std::vector<std::string> conditions;
    for (const auto& element : rule_.elements)
      if (takeConvexity(element, triples)) {
        std::vector<std::string> corners;
        for (int v : element) corners.push_back(name(v));
        conditions.push_back("convex(" + joined(corners) + ")");
      }
    for (const auto& t : triples)
      conditions.push_back("ccw(" + name(t[0]) + ", " + name(t[1]) + ", " + name(t[2]) + ")");
    clause("require", conditions);
  }

  /// Whether all four corners of a quadrilateral are required to turn left; if so, removes these
  /// conditions.
  static bool takeConvexity(const std::vector<int>& element,
                            std::set<std::array<int, 3>>& triples) {
    if (element.size() != 4) return false;
    std::set<std::array<int, 3>> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<int, 3> t{element[i], element[(i + 1) % 4], element[(i + 2) % 4]};
      std::ranges::rotate(t, std::ranges::min_element(t));
      corners.insert(t);
    }
    if (!std::ranges::includes(triples, corners)) return false;
    for (const auto& t : corners) triples.erase(t);
    return true;
  }

  void writeNewVertices() {
    std::vector<std::string> places;
    for (std::size_t i = 0; i < rule_.added.size(); ++i) {
      const std::string& name = names_[rule_.matched.size() + i];
      places.push_back(name + " = " + pointExpression(rule_.added[i], points_));
      points_.push_back({name, rule_.added[i]});
    }
    clause("new", places);
  }

  void writeZone() {
    std::vector<std::string> corners;
    for (const ClassicRule::Corner& corner : rule_.zone) {
      const std::string preferred = pointExpression(corner.preferred, points_);
      const bool fades = corner.preferred != corner.limiting;
      corners.push_back(fades ? preferred + " => " + pointExpression(corner.limiting, points_)
                              : preferred);
    }
    clause("zone", corners);
  }

  void writeElements() {
    for (std::size_t size : {3u, 4u}) {
      std::vector<std::string> elements;
      for (const auto& element : rule_.elements) {
        if (element.size() != size) continue;
        std::vector<std::string> corners;
        for (int v : element) corners.push_back(name(v));
        elements.push_back(joined(corners, " "));
      }
      clause(size == 3 ? "tri " : "quad", elements);
    }
  }

  const ClassicRule& rule_;
  std::vector<std::string> names_;
  std::vector<NamedPoint> points_;
  RuleText text_;
};

}  // namespace

std::vector<std::string> vertexNames(const ClassicRule& rule) {
  // Excludes names that families and the language use.
  constexpr std::array kNames{"a", "b", "c", "d", "e", "f", "g", "i", "j", "m", "n", "o"};
  std::vector<std::string> names;
  for (std::size_t v = 0; v < rule.matched.size() + rule.added.size(); ++v)
    names.emplace_back(kNames.at(v));
  return names;
}

RuleText ruleText(const ClassicRule& rule, const std::string& title) {
  return Writer(rule, title).write();
}

std::string mirrorClause(const ClassicRule& rule, const ClassicRule& other, const Twin& twin,
                         const std::string& otherTitle) {
  std::string clause = "mirror \"" + otherTitle + "\"";
  if (!twin.hasOwnQuality && twin.ownForms.empty()) return clause + ";";
  clause += " {";
  if (twin.hasOwnQuality) clause += " quality " + std::to_string(other.quality) + ";";
  const std::vector<std::string> names = vertexNames(rule);
  std::vector<std::string> forms;
  for (int v : twin.ownForms) {
    const auto own = static_cast<std::size_t>(twin.vertices[static_cast<std::size_t>(v)]);
    forms.push_back(names[static_cast<std::size_t>(v)] + " ~ " + formText(other.matched[own].form));
  }
  if (!forms.empty()) clause += " at " + joined(forms) + ";";
  return clause + " }";
}

}  // namespace af2::dsl
