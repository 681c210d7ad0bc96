#include "dsl/netgen/rls_twins.h"

#include <algorithm>
#include <set>

namespace af2::dsl {
namespace {

using VertexNumbers = std::vector<int>;

/// A cycle that starts at its smallest vertex.
VertexNumbers rotated(VertexNumbers cycle) {
  std::rotate(cycle.begin(), std::ranges::min_element(cycle), cycle.end());
  return cycle;
}

/// For each vertex of `rule` the vertex of `other` at the position of its mirror image.
std::optional<VertexNumbers> correspondence(const ClassicRule& rule, const ClassicRule& other) {
  if (rule.matched.size() != other.matched.size() || rule.added.size() != other.added.size())
    return std::nullopt;
  VertexNumbers vertices{1, 0};
  for (std::size_t v = 2; v < rule.matched.size(); ++v) {
    const Exact x = 1 - rule.matched[v].x, y = rule.matched[v].y;
    const auto found = std::find_if(other.matched.begin() + 2, other.matched.end(),
                                    [&](const auto& m) { return m.x == x && m.y == y; });
    if (found == other.matched.end()) return std::nullopt;
    vertices.push_back(static_cast<int>(found - other.matched.begin()));
  }
  if (std::set<int>(vertices.begin(), vertices.end()).size() != vertices.size())
    return std::nullopt;
  return vertices;
}

/// The mirrored map, with its vertices renumbered to those of the other rule.
ExactMap imageOf(const ExactMap& map, const VertexNumbers& vertices) {
  const ExactMap image = mirrored(map);
  ExactMap result = image;
  for (std::size_t row = 0; row < 2; ++row)
    for (std::size_t v = 2; 2 * v < image.weights[row].size(); ++v)
      for (std::size_t k : {0, 1})
        result.weights[row][2 * static_cast<std::size_t>(vertices[v]) + k] =
            image.weights[row][2 * v + k];
  return result;
}

class Comparison {
 public:
  Comparison(const ClassicRule& rule, const ClassicRule& other, VertexNumbers vertices)
      : rule_(rule), other_(other), vertices_(std::move(vertices)) {
    for (std::size_t i = 0; i < rule.added.size(); ++i)
      vertices_.push_back(static_cast<int>(rule.matched.size() + i));
  }

  bool haveLikePattern() const {
    std::set<std::pair<int, int>> image, own;
    for (const auto& e : rule_.edges) image.insert({at(e.to), at(e.from)});
    for (const auto& e : other_.edges) own.insert({e.from, e.to});
    return image == own && !hasSlopes(rule_) && !hasSlopes(other_);
  }

  /// New vertices may be numbered differently: tries all orders if there are few.
  bool haveLikeElements() {
    constexpr std::size_t kMaxReordered = 5;
    if (rule_.added.size() > kMaxReordered)
      return elementsOf(rule_, true) == elementsOf(other_, false);
    const auto matched = static_cast<std::ptrdiff_t>(rule_.matched.size());
    do {
      if (elementsOf(rule_, true) == elementsOf(other_, false)) return true;
    } while (std::next_permutation(vertices_.begin() + matched, vertices_.end()));
    return false;
  }

  std::string difference() const {
    std::string parts;
    const auto add = [&](bool differs, const char* what) {
      if (differs) parts += (parts.empty() ? "" : " and ") + std::string(what);
    };
    add(!haveLikeNewVertices(), "the new points");
    add(zone(rule_, true, &ClassicRule::Corner::preferred) !=
            zone(other_, false, &ClassicRule::Corner::preferred),
        "freearea");
    add(zone(rule_, true, &ClassicRule::Corner::limiting) !=
            zone(other_, false, &ClassicRule::Corner::limiting),
        "freearea2");
    add(orientations(rule_, true) != orientations(other_, false), "orientations");
    return parts;
  }

  Twin twin() const {
    Twin twin{vertices_, rule_.quality != other_.quality, {}};
    for (std::size_t v = 2; v < rule_.matched.size(); ++v) {
      const ExactForm& own = other_.matched[static_cast<std::size_t>(vertices_[v])].form;
      if (mirrored(rule_.matched[v].form) != own) twin.ownForms.push_back(static_cast<int>(v));
    }
    return twin;
  }

 private:
  static bool hasSlopes(const ClassicRule& rule) {
    return std::ranges::any_of(rule.edges, [](const auto& e) { return e.slope.has_value(); });
  }

  int at(int v) const { return vertices_[static_cast<std::size_t>(v)]; }

  std::set<VertexNumbers> elementsOf(const ClassicRule& rule, bool isImage) const {
    std::set<VertexNumbers> result;
    for (VertexNumbers element : rule.elements) {
      if (isImage) {
        std::ranges::reverse(element);
        for (int& v : element) v = at(v);
      }
      result.insert(rotated(element));
    }
    return result;
  }

  bool haveLikeNewVertices() const {
    for (std::size_t i = 0; i < rule_.added.size(); ++i) {
      const auto j = static_cast<std::size_t>(vertices_[rule_.matched.size() + i]);
      if (imageOf(rule_.added[i], vertices_) != other_.added[j - other_.matched.size()])
        return false;
    }
    return true;
  }

  /// The corners, beginning with the one at a, as comparable numbers.
  std::vector<ExactMap> zone(const ClassicRule& rule, bool isImage,
                             ExactMap ClassicRule::Corner::*part) const {
    std::vector<ExactMap> corners;
    for (const auto& corner : rule.zone)
      corners.push_back(isImage ? imageOf(corner.*part, vertices_) : corner.*part);
    if (isImage) std::ranges::reverse(corners);
    const auto origin = std::ranges::find_if(corners, [](const ExactMap& map) {
      const auto isNone = [](const Exact& w) { return w == 0; };
      return map.constant[0] == 0 && map.constant[1] == 0 &&
             std::ranges::all_of(map.weights[0], isNone) &&
             std::ranges::all_of(map.weights[1], isNone);
    });
    if (origin != corners.end()) std::rotate(corners.begin(), origin, corners.end());
    return corners;
  }

  /// Corners of new elements are left out, because new elements always turn left at every corner.
  static bool isImplied(const ClassicRule& rule, const VertexNumbers& triple) {
    return std::ranges::any_of(rule.elements, [&](const VertexNumbers& element) {
      const auto place = [&](int v) { return std::ranges::find(element, v) - element.begin(); };
      const std::ptrdiff_t n = std::ssize(element);
      const std::ptrdiff_t i = place(triple[0]), j = place(triple[1]), k = place(triple[2]);
      return i < n && j < n && k < n && (j - i + n) % n < (k - i + n) % n;
    });
  }

  std::set<VertexNumbers> orientations(const ClassicRule& rule, bool isImage) const {
    std::set<VertexNumbers> result;
    for (const auto& triple : rule.orientations) {
      VertexNumbers v(triple.begin(), triple.end());
      if (isImplied(rule, v)) continue;
      if (isImage) v = {at(triple[2]), at(triple[1]), at(triple[0])};
      result.insert(rotated(v));
    }
    return result;
  }

  const ClassicRule &rule_, &other_;
  VertexNumbers vertices_;
};

}  // namespace

ExactForm mirrored(const ExactForm& form) { return {form[0], -form[1], form[2]}; }

std::optional<Twin> findTwin(const ClassicRule& rule, const ClassicRule& other,
                             std::string& difference) {
  difference.clear();
  const auto vertices = correspondence(rule, other);
  if (!vertices) return std::nullopt;
  Comparison comparison(rule, other, *vertices);
  if (!comparison.haveLikePattern() || !comparison.haveLikeElements()) return std::nullopt;
  difference = comparison.difference();
  if (!difference.empty()) return std::nullopt;
  return comparison.twin();
}

}  // namespace af2::dsl
