#include "dsl/netgen/rls_rule.h"

#include <algorithm>
#include <set>

namespace af2::dsl {
namespace {

using DirectedEdge = std::pair<int, int>;
using EdgeSet = std::set<DirectedEdge>;

Exact cross(const std::array<Exact, 2>& o, const std::array<Exact, 2>& p,
            const std::array<Exact, 2>& q) {
  return (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
}

/// The boundary: directed edges of the elements whose reverse is not an edge of an element.
EdgeSet boundaryOf(const std::vector<std::vector<int>>& elements) {
  EdgeSet edges;
  for (const auto& element : elements)
    for (std::size_t i = 0; i < element.size(); ++i)
      edges.insert({element[i], element[(i + 1) % element.size()]});
  EdgeSet boundary;
  for (const DirectedEdge& e : edges)
    if (!edges.contains({e.second, e.first})) boundary.insert(e);
  return boundary;
}

class Converter {
 public:
  Converter(const RlsRule& text, const SourceText& source, DiagnosticList& diagnostics)
      : text_(text), source_(source), diagnostics_(diagnostics) {}

  ClassicRule convert() {
    rule_.title = text_.name;
    rule_.span = text_.span;
    readQuality();
    numberVertices();
    readPattern();
    readNewPoints();
    readElements();
    readZone();
    readOrientations();
    if (checkElements()) checkFront();
    return std::move(rule_);
  }

 private:
  void warn(Code code, Span span, std::string message, std::string help, bool isRemark = true) {
    if (isRemark) rule_.remarks.push_back(message);
    Diagnostic d = rlsFinding(code, placeOf(source_, span), std::move(message), std::move(help));
    d.rule = text_.name;
    diagnostics_.add(std::move(d));
  }

  void readQuality() {
    rule_.quality = std::max(1, text_.quality);
    if (rule_.quality > kLastClassicLevel)
      warn(Code::NetgenSwitchedOff, text_.qualitySpan,
           "quality " + std::to_string(rule_.quality) + " switches this rule off: levels end at " +
               std::to_string(kLastClassicLevel),
           "leave the rule out, or give it a level that is reached");
  }

  void numberVertices() {
    const RlsLine& base = text_.mapLines.front();
    const auto count = static_cast<int>(text_.mapPoints.size());
    order_ = {base.from, base.to};
    for (int i = 1; i <= count; ++i)
      if (i != base.from && i != base.to) order_.push_back(i);
    for (std::size_t i = 1; i <= text_.newPoints.size(); ++i)
      order_.push_back(count + static_cast<int>(i));
    if (base.from != 1 || base.to != 2)
      warn(Code::NetgenRenamed, base.span,
           "the base edge of this rule runs from point " + std::to_string(base.from) +
               " to point " + std::to_string(base.to) + "; these became a and b",
           "");
  }

  int vertex(int fileNumber) const {
    return static_cast<int>(std::ranges::find(order_, fileNumber) - order_.begin());
  }

  std::vector<int> vertices(const RlsTuple& tuple) const {
    std::vector<int> result;
    for (int point : tuple.points) result.push_back(vertex(point));
    return result;
  }

  std::string fileNumbers(const std::vector<int>& vertices) const {
    std::string text;
    for (int v : vertices)
      text += (text.empty() ? "(" : ", ") + std::to_string(order_[static_cast<std::size_t>(v)]);
    return text + ")";
  }

  const RlsMapPoint& mapPoint(std::size_t v) const {
    return text_.mapPoints[static_cast<std::size_t>(order_[v] - 1)];
  }

  void readPattern() {
    for (std::size_t v = 0; v < text_.mapPoints.size(); ++v) {
      const RlsMapPoint& point = mapPoint(v);
      ClassicRule::Vertex vertex{point.x, point.y};
      if (v < 2 && point.form) {
        if (point.form->weights != std::array<Exact, 3>{1, 0, 1})
          warn(Code::NetgenIdlePart, point.span,
               "a tolerance on an end of the base edge has no effect",
               "the base edge is always matched, whatever its length", false);
      } else if (point.form) {
        vertex.form = point.form->weights;
      }
      if (point.isDeleted)
        warn(Code::NetgenIdlePart, point.span, "'del' on a point has no effect",
             "edges are deleted, not points", false);
      rule_.matched.push_back(vertex);
    }
    const auto stands = [&](std::size_t v, int x) {
      return rule_.matched[v].x == x && rule_.matched[v].y == 0;
    };
    if (!stands(0, 0) || !stands(1, 1))
      warn(Code::NetgenRenamed, mapPoint(0).span,
           "the base edge of this rule does not run from (0, 0) to (1, 0)",
           "deviations of its ends are taken from where the rule puts them");
    for (const RlsLine& line : text_.mapLines) {
      ClassicRule::Edge edge{vertex(line.from), vertex(line.to), std::nullopt};
      const bool acts = line.form && std::ranges::any_of(line.form->weights,
                                                         [](const Exact& w) { return w != 0; });
      if (acts) edge.slope = line.form->weights;
      rule_.edges.push_back(edge);
    }
  }

  ExactMap mapOf(const RlsPoint& point) {
    ExactMap map;
    const std::size_t count = text_.mapPoints.size();
    map.constant = {point.x, point.y};
    for (std::size_t row = 0; row < 2; ++row) {
      map.weights[row].assign(2 * count, 0);
      for (const RlsTerm& term : point.rows[row]) add(map, row, term);
    }
    for (std::size_t row = 0; row < 2; ++row) {
      for (std::size_t v = 0; v < count; ++v)
        map.constant[row] -= map.weights[row][2 * v] * rule_.matched[v].x +
                             map.weights[row][2 * v + 1] * rule_.matched[v].y;
      for (std::size_t inert : {0, 1, 3}) map.weights[row][inert] = 0;
    }
    return map;
  }

  void add(ExactMap& map, std::size_t row, const RlsTerm& term) {
    if (term.point < 1 || term.point > static_cast<int>(text_.mapPoints.size())) {
      warn(Code::NetgenIdlePart, term.span,
           "there is no point " + std::to_string(term.point) +
               " to follow; Netgen ignores this term, and so does the imported rule",
           "points to follow are the mappoints, 1 to " + std::to_string(text_.mapPoints.size()));
      return;
    }
    const auto v = static_cast<std::size_t>(vertex(term.point));
    Exact& weight = map.weights[row][2 * v + (term.isX ? 0 : 1)];
    if (weight != 0)
      warn(Code::NetgenIdlePart, term.span,
           "this coordinate occurs twice in one row: the last one is used", "");
    weight = term.coefficient;
  }

  void readNewPoints() {
    for (const RlsPoint& point : text_.newPoints) {
      rule_.added.push_back(mapOf(point));
      if (rule_.added.back().isPointSum()) continue;
      warn(Code::NetgenMismatch, point.span,
           "this point is not a sum of points: its x and its y do not follow the same matched "
           "points",
           "it is kept as it is, but a front that is turned a little gets another element");
    }
  }

  void readElements() {
    for (const RlsTuple& tuple : text_.elements) rule_.elements.push_back(vertices(tuple));
  }

  void readZone() {
    const std::size_t corners = text_.freeArea.size(), limits = text_.freeArea2.size();
    if (limits > 0 && limits != corners)
      warn(Code::NetgenMismatch, text_.freeArea2.back().span,
           "freearea2 has " + std::to_string(limits) + " corners, freearea " +
               std::to_string(corners) + ": " +
               (limits < corners ? "corners without a limit keep their preferred place"
                                 : "the last ones are left out"),
           "give both the same corners in the same order");
    for (std::size_t i = 0; i < corners; ++i) {
      ClassicRule::Corner corner{mapOf(text_.freeArea[i]), {}};
      corner.limiting = i < limits ? mapOf(text_.freeArea2[i]) : corner.preferred;
      rule_.zone.push_back(std::move(corner));
    }
    checkTurns(text_.freeArea, "freearea");
    if (limits == corners) checkTurns(text_.freeArea2, "freearea2");
  }

  void checkTurns(const std::vector<RlsPoint>& area, const std::string& name) {
    const std::size_t n = area.size();
    for (std::size_t i = 0; i < n; ++i) {
      const auto at = [&](std::size_t k) {
        return std::array<Exact, 2>{area[k % n].x, area[k % n].y};
      };
      if (cross(at(i), at(i + 1), at(i + 2)) >= 0) continue;
      warn(Code::NetgenMismatch, area[(i + 1) % n].span,
           "the corners of " + name +
               " do not run counter-clockwise around a convex region, so that this rule seldom or "
               "never applies",
           "");
      return;
    }
  }

  void readOrientations() {
    for (const RlsTuple& tuple : text_.orientations) {
      const std::vector<int> v = vertices(tuple);
      rule_.orientations.push_back({v[0], v[1], v[2]});
      if (cross(reference(v[0]), reference(v[1]), reference(v[2])) < 0)
        warn(Code::NetgenMismatch, tuple.span,
             "these points are clockwise where the rule expects them",
             "the rule then applies to other positions only");
    }
  }

  /// The position of a vertex if all matched points are at their references.
  std::array<Exact, 2> reference(int v) const {
    const auto i = static_cast<std::size_t>(v);
    if (i < rule_.matched.size()) return {rule_.matched[i].x, rule_.matched[i].y};
    const RlsPoint& point = text_.newPoints[i - rule_.matched.size()];
    return {point.x, point.y};
  }

  bool isTurnedLeft(const std::vector<int>& element) const {
    const std::size_t n = element.size();
    for (std::size_t i = 0; i < n; ++i)
      if (cross(reference(element[i]), reference(element[(i + 1) % n]),
                reference(element[(i + 2) % n])) <= 0)
        return false;
    return true;
  }

  EdgeSet statedBoundary() const {
    EdgeSet stated;
    for (const RlsLine& line : text_.mapLines)
      if (line.isDeleted) stated.insert({vertex(line.from), vertex(line.to)});
    for (const RlsTuple& line : text_.newLines)
      stated.insert({vertex(line.points[1]), vertex(line.points[0])});
    return stated;
  }

  /// The only element that could replace elements[i] so that the rule agrees with del and newlines.
  std::optional<std::vector<int>> fittingElement(std::size_t i) const {
    const EdgeSet stated = statedBoundary();
    std::vector<std::vector<int>> elements = rule_.elements;
    const auto count = static_cast<int>(order_.size());
    std::vector<int>& element = elements[i];
    std::vector<int> digits(element.size(), 0);
    for (bool isDone = false; !isDone;) {
      const bool isRotated = digits.front() != *std::ranges::min_element(digits);
      element = digits;
      if (!isRotated && isTurnedLeft(element) && boundaryOf(elements) == stated) return element;
      std::size_t k = 0;
      while (k < digits.size() && ++digits[k] == count) digits[k++] = 0;
      isDone = k == digits.size();
    }
    return std::nullopt;
  }

  /// False if one wrong element explains all differences of the front.
  bool checkElements() {
    bool isExplained = false;
    for (std::size_t i = 0; i < rule_.elements.size(); ++i) {
      if (isTurnedLeft(rule_.elements[i])) continue;
      const auto better = fittingElement(i);
      warn(Code::NetgenMismatch, text_.elements[i].span,
           "this element does not run counter-clockwise where the rule expects its corners",
           better ? "with " + fileNumbers(*better) + " instead, everything else would fit"
                  : "elements run counter-clockwise");
      isExplained |= better.has_value();
    }
    return !isExplained;
  }

  /// The elements determine the edges that leave and join the front. The statements of the file
  /// about these edges are only compared with the elements.
  void checkFront() {
    const EdgeSet boundary = boundaryOf(rule_.elements);
    EdgeSet pattern;
    for (const RlsLine& line : text_.mapLines) {
      const DirectedEdge edge{vertex(line.from), vertex(line.to)};
      pattern.insert(edge);
      if (line.isDeleted == boundary.contains(edge)) continue;
      warn(Code::NetgenMismatch, line.span,
           line.isDeleted ? "this edge is deleted, but no new element lies at it"
                          : "a new element lies at this edge, but it is not deleted",
           "the imported rule follows its elements");
    }
    EdgeSet wanted;
    for (const DirectedEdge& e : boundary)
      if (!pattern.contains(e)) wanted.insert({e.second, e.first});
    for (const RlsTuple& line : text_.newLines) {
      const DirectedEdge edge{vertex(line.points[0]), vertex(line.points[1])};
      if (wanted.erase(edge) > 0) continue;
      warn(Code::NetgenMismatch, line.span, "this new line is not a free edge of the new elements",
           "the imported rule follows its elements");
    }
    for (const DirectedEdge& e : wanted)
      warn(Code::NetgenMismatch, text_.span,
           "the new elements have a free edge " + fileNumbers({e.first, e.second}) +
               " that newlines does not name",
           "the imported rule follows its elements");
  }

  const RlsRule& text_;
  const SourceText& source_;
  DiagnosticList& diagnostics_;
  std::vector<int> order_;  // file numbers by vertex
  ClassicRule rule_;
};

}  // namespace

bool ExactMap::isPointSum() const {
  if (weights[1][2] != 0) return false;
  for (std::size_t v = 2; 2 * v < weights[0].size(); ++v)
    if (weights[0][2 * v] != weights[1][2 * v + 1] || weights[0][2 * v + 1] != 0 ||
        weights[1][2 * v] != 0)
      return false;
  return true;
}

// With L = x of b: x becomes L - x, both at the matched points and at the new point.
ExactMap mirrored(const ExactMap& map) {
  ExactMap result = map;
  result.constant[0] = -map.constant[0];
  Exact share = 1 - map.weights[0][2], lift = map.weights[1][2];
  for (std::size_t v = 2; 2 * v < map.weights[0].size(); ++v) {
    share -= map.weights[0][2 * v];
    lift += map.weights[1][2 * v];
    result.weights[0][2 * v + 1] = -map.weights[0][2 * v + 1];
    result.weights[1][2 * v] = -map.weights[1][2 * v];
  }
  result.weights[0][2] = share;
  result.weights[1][2] = lift;
  return result;
}

ClassicRule toClassicRule(const RlsRule& rule, const SourceText& source,
                          DiagnosticList& diagnostics) {
  return Converter(rule, source, diagnostics).convert();
}

}  // namespace af2::dsl
