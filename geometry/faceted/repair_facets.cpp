#include "geometry/faceted/repair_facets.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <ranges>
#include <set>

#include "geometry/base/box_tree.h"
#include "geometry/base/disjoint_sets.h"
#include "geometry/faceted/flats.h"
#include "geometry/faceted/half_edges.h"
#include "geometry/faceted/touching_parts.h"

namespace af2::geometry {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Edge = FacetEdge;

/// Edges that lie nearer than this share of the diagonal are one.
constexpr double kSame = 1e-5;
/// The coordinates of binary STL files are no more exact than this share.
constexpr double kTiny = 1e-7;

class Repair {
 public:
  explicit Repair(Facets& facets) : facets_(facets) {
    Box3 box;
    for (const Point3& p : facets.vertices) box.add(p);
    diagonal_ = distance(box.low, box.high);
    tolerance_ = kSame * diagonal_;
  }

  void repair() {
    collapseTinyEdges();
    dropTwins(Twins::SameSide);
    joinVertices();
    splitAtVertices();
    turn();
    partTouching(facets_);
    dropTwins(Twins::BothSides);
    turn();  // sheets whose triangles were there from both sides
    if (twins_ > 0)
      note(twins_, "triangles had the same corners as others and were left out", *twinPlace_);
    noteOneSided();
    noteHoles();
  }

 private:
  std::uint32_t startOf(HalfEdge h) const { return geometry::startOf(facets_.triangles, h); }
  std::uint32_t endOf(HalfEdge h) const { return geometry::endOf(facets_.triangles, h); }
  Edge edgeOf(HalfEdge h) const { return geometry::edgeOf(facets_.triangles, h); }
  const Point3& at(std::uint32_t v) const { return facets_.vertices[v]; }

  void note(std::size_t count, const char* what, const Point3& place) {
    if (count == 0) return;
    char text[200];
    std::snprintf(text, sizeof text, "%zu %s, the first near (%.9g, %.9g, %.9g)", count, what,
                  place.x, place.y, place.z);
    facets_.notes.emplace_back(text);
  }

  void erase(const std::vector<bool>& isDropped) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < facets_.triangles.size(); ++t) {
      if (isDropped[t]) continue;
      facets_.triangles[kept] = facets_.triangles[t];
      if (!facets_.group.empty()) facets_.group[kept] = facets_.group[t];
      ++kept;
    }
    facets_.triangles.resize(kept);
    if (!facets_.group.empty()) facets_.group.resize(kept);
  }

  template <class NameOf>
  void rename(const NameOf& nameOf) {
    std::vector<bool> isGone(facets_.triangles.size(), false);
    for (std::size_t t = 0; t < isGone.size(); ++t) {
      Triangle& c = facets_.triangles[t];
      for (std::uint32_t& v : c) v = nameOf(v);
      isGone[t] = c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
    }
    erase(isGone);
  }

  void collapseTinyEdges() {
    DisjointSets sets(facets_.vertices.size());
    std::size_t count = 0;
    Point3 place;
    for (HalfEdge h = 0; h < 3 * facets_.triangles.size(); ++h) {
      const std::uint32_t from = startOf(h), to = endOf(h);
      if (distance(at(from), at(to)) > kTiny * diagonal_ || sets.of(from) == sets.of(to)) continue;
      sets.join(from, to);
      if (count++ == 0) place = at(from);
    }
    if (count == 0) return;
    rename([&](std::uint32_t v) { return sets.of(v); });
    note(count, "edges without length were collapsed", place);
  }

  enum class Twins { SameSide, BothSides };

  void dropTwins(Twins which) {
    std::vector<std::pair<Triangle, std::uint32_t>> sorted;
    for (std::uint32_t t = 0; t < facets_.triangles.size(); ++t) {
      Triangle corners = facets_.triangles[t];
      if (which == Twins::BothSides)
        std::ranges::sort(corners);
      else
        std::ranges::rotate(corners, std::ranges::min_element(corners));
      sorted.emplace_back(corners, t);
    }
    std::ranges::sort(sorted);
    std::vector<bool> isTwin(sorted.size(), false);
    for (std::size_t i = 1; i < sorted.size(); ++i)
      isTwin[sorted[i].second] = sorted[i].first == sorted[i - 1].first;
    if (which == Twins::SameSide)
      keepThoseOfParts(isTwin);
    else
      addFlaps(sorted, isTwin);
    for (std::uint32_t t = 0; t < isTwin.size(); ++t) {
      if (!isTwin[t]) continue;
      ++twins_;
      if (!twinPlace_) twinPlace_ = at(facets_.triangles[t][0]);
    }
    erase(isTwin);
  }

  /// Both of two triangles without area that hang on others which match without them.
  void addFlaps(const std::vector<std::pair<Triangle, std::uint32_t>>& sorted,
                std::vector<bool>& isTwin) const {
    const auto isFlat = [&](const Triangle& c) {
      const Point3 p = at(c[1]) - at(c[0]), q = at(c[2]) - at(c[0]);
      const double longest = std::max({length(p), length(q), length(q - p)});
      return length(cross(p, q)) <= kTiny * diagonal_ * longest;
    };
    std::vector<bool> isFlap(isTwin.size(), false);
    for (std::size_t i = 1; i < sorted.size(); ++i)
      if (sorted[i].first == sorted[i - 1].first && isFlat(sorted[i].first))
        isFlap[sorted[i - 1].second] = isFlap[sorted[i].second] = true;
    if (std::ranges::none_of(isFlap, std::identity())) return;
    HalfEdges(facets_.triangles).forEachEdge([&](const Edge&, auto halves) {
      const auto others = std::ranges::count_if(halves, [&](HalfEdge h) { return !isFlap[h / 3]; });
      if (others >= 2 || (others == 0 && halves.size() == 2)) return;
      for (const HalfEdge h : halves) isFlap[h / 3] = false;
    });
    for (std::size_t t = 0; t < isTwin.size(); ++t) isTwin[t] = isTwin[t] || isFlap[t];
  }

  /// Where each edge is used equally often in both directions, closed parts coincide, and removing
  /// their triangles would leave holes. Superfluous twins are connected to edges where this does
  /// not hold.
  void keepThoseOfParts(std::vector<bool>& isTwin) const {
    if (std::ranges::none_of(isTwin, std::identity())) return;
    std::vector<HalfEdge> open;
    std::vector<std::vector<HalfEdge>> around;
    HalfEdges(facets_.triangles).forEachEdge([&](const Edge& edge, auto halves) {
      std::ptrdiff_t balance = 0;
      std::vector<HalfEdge> twins;
      for (const HalfEdge h : halves) {
        balance += startOf(h) == edge.first ? 1 : -1;
        if (isTwin[h / 3]) twins.push_back(h);
      }
      if (twins.empty()) return;
      if (balance != 0) open.insert(open.end(), twins.begin(), twins.end());
      around.push_back(std::move(twins));
    });
    DisjointSets sets(facets_.triangles.size());
    for (const auto& twins : around)
      for (const HalfEdge h : twins) sets.join(h / 3, twins.front() / 3);
    std::set<std::uint32_t> redundant;
    for (const HalfEdge h : open) redundant.insert(sets.of(h / 3));
    for (std::uint32_t t = 0; t < isTwin.size(); ++t)
      isTwin[t] = isTwin[t] && redundant.contains(sets.of(t));
  }

  /// Edges with one triangle.
  std::vector<HalfEdge> openEdges() const { return HalfEdges(facets_.triangles).boundary(); }

  void noteOneSided() {
    const std::vector<HalfEdge> twin = HalfEdges(facets_.triangles).twins();
    std::vector<HalfEdge> against;
    for (HalfEdge h = 0; h < twin.size(); ++h)
      if (twin[h] != kNoHalfEdge && h < twin[h] && startOf(h) == startOf(twin[h]))
        against.push_back(h);
    if (against.empty()) return;
    note(against.size(),
         "edges are kept between triangles of opposite orientations, since no reversal makes all "
         "match",
         at(startOf(against.front())));
  }

  /// They are no fault of a sheet, but of what is meant to be a solid.
  void noteHoles() {
    const std::vector<HalfEdge> open = openEdges();
    if (open.empty()) return;
    note(open.size(), "edges have only one triangle: the surface is open there",
         at(startOf(open.front())));
  }

  std::vector<std::uint32_t> verticesOf(const std::vector<HalfEdge>& open) const {
    std::vector<std::uint32_t> vertices;
    for (const HalfEdge h : open) vertices.insert(vertices.end(), {startOf(h), endOf(h)});
    std::ranges::sort(vertices);
    vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
    return vertices;
  }

  BoxTree treeOf(const std::vector<std::uint32_t>& vertices) const {
    std::vector<Box3> boxes;
    for (const std::uint32_t v : vertices) boxes.emplace_back().add(at(v));
    return BoxTree(boxes);
  }

  static Box3 around(const Point3& p, double reach) {
    const Point3 r{reach, reach, reach};
    return {p - r, p + r};
  }

  /// Vertices of open edges become one with an earlier one that is near.
  void joinVertices() {
    const std::vector<HalfEdge> open = openEdges();
    const std::vector<std::uint32_t> vertices = verticesOf(open);
    const BoxTree tree = treeOf(vertices);
    std::vector<std::uint32_t> same(facets_.vertices.size());
    std::iota(same.begin(), same.end(), 0u);
    std::size_t count = 0;
    Point3 place;
    const double reach = reachOf(open);
    for (const std::uint32_t v : vertices) {
      if (same[v] != v) continue;
      tree.forEachIn(around(at(v), reach), [&](std::uint32_t i) {
        const std::uint32_t w = vertices[i];
        if (w <= v || same[w] != w || distance(at(v), at(w)) > reach) return;
        same[w] = v;
        if (count++ == 0) place = at(v);
      });
    }
    if (count == 0) return;
    rename([&](std::uint32_t v) { return same[v]; });
    note(count, "vertices at gaps were merged with nearby ones", place);
  }

  /// Not so far that short edges would vanish.
  double reachOf(const std::vector<HalfEdge>& open) const {
    constexpr double kOfShortest = 0.2;
    double shortest = tolerance_ / kOfShortest;
    for (const HalfEdge h : open) {
      const double length = distance(at(startOf(h)), at(endOf(h)));
      if (length > tolerance_) shortest = std::min(shortest, length);
    }
    return kOfShortest * shortest;
  }

  /// Where several open edges run along one, its triangle is split at their vertices.
  void splitAtVertices() {
    std::size_t count = 0;
    std::optional<Point3> place;
    for (int sides = 0; sides < 3; ++sides) {  // a triangle may be split at each of them
      const std::vector<HalfEdge> open = openEdges();
      const std::vector<std::uint32_t> vertices = verticesOf(open);
      const BoxTree tree = treeOf(vertices);
      std::map<std::uint32_t, std::vector<HalfEdge>> leaving;  // by vertex: open edges at it
      for (const HalfEdge h : open)
        for (const std::uint32_t v : {startOf(h), endOf(h)}) leaving[v].push_back(h);
      std::vector<bool> isSplit(facets_.triangles.size(), false);
      std::size_t split = 0;
      for (const HalfEdge h : open) {
        if (isSplit[h / 3]) continue;
        const std::vector<std::uint32_t> inner = verticesAlong(h, vertices, tree);
        if (inner.empty() || !isChain(h, inner, leaving)) continue;
        const std::uint32_t apex = startOf(previousIn(h));
        if (std::ranges::count(inner, apex) > 0) continue;  // of no area: there is nothing to split
        isSplit[h / 3] = true;
        if (!place) place = at(inner.front());
        splitTriangle(h, inner);
        ++split;
      }
      count += split;
      if (split == 0) break;
    }
    if (place)
      note(count, "triangles were split where vertices of others lay on their edges", *place);
  }

  std::vector<std::uint32_t> verticesAlong(HalfEdge h, const std::vector<std::uint32_t>& vertices,
                                           const BoxTree& tree) const {
    const Point3 from = at(startOf(h)), along = at(endOf(h)) - from;
    const double square = dot(along, along);
    std::vector<std::pair<double, std::uint32_t>> found;
    Box3 box = around(from, tolerance_);
    box.add(around(at(endOf(h)), tolerance_));
    tree.forEachIn(box, [&](std::uint32_t i) {
      const std::uint32_t v = vertices[i];
      if (v == startOf(h) || v == endOf(h)) return;
      const double within = dot(at(v) - from, along) / square;
      if (!(within > 0 && within < 1)) return;
      if (distance(at(v), from + within * along) <= tolerance_) found.emplace_back(within, v);
    });
    std::ranges::sort(found);
    const auto inner = found | std::views::values;
    return {inner.begin(), inner.end()};
  }

  /// Whether open edges lead from the start of an edge over these vertices to its end.
  bool isChain(HalfEdge h, const std::vector<std::uint32_t>& inner,
               const std::map<std::uint32_t, std::vector<HalfEdge>>& leaving) const {
    std::uint32_t from = startOf(h);
    const auto isOpen = [&](std::uint32_t a, std::uint32_t b) {
      return std::ranges::any_of(leaving.at(a),
                                 [&](HalfEdge g) { return edgeOf(g) == Edge(std::minmax(a, b)); });
    };
    for (const std::uint32_t v : inner) {
      if (!isOpen(from, v)) return false;
      from = v;
    }
    return isOpen(from, endOf(h));
  }

  void splitTriangle(HalfEdge h, const std::vector<std::uint32_t>& inner) {
    const std::uint32_t t = h / 3, last = endOf(h), apex = startOf(previousIn(h));
    std::uint32_t from = startOf(h);
    facets_.triangles[t] = {from, inner[0], apex};
    for (std::size_t i = 0; i < inner.size(); ++i) {
      facets_.triangles.push_back({inner[i], i + 1 < inner.size() ? inner[i + 1] : last, apex});
      if (!facets_.group.empty()) facets_.group.push_back(facets_.group[t]);
    }
  }

  /// Across edges with two triangles; of each connected part the smaller area is turned. A part
  /// that has no two sides stays as it is.
  void turn() {
    const std::vector<HalfEdge> twin = HalfEdges(facets_.triangles).twins();
    bool isTurned = false;
    for (HalfEdge h = 0; h < twin.size(); ++h)
      isTurned = isTurned || (twin[h] != kNoHalfEdge && startOf(h) == startOf(twin[h]));
    if (!isTurned) return;
    std::vector<int> side(facets_.triangles.size(), 0);
    std::size_t count = 0;
    Point3 place;
    for (std::uint32_t first = 0; first < side.size(); ++first) {
      if (side[first] != 0) continue;
      const std::vector<std::uint32_t> part = partFrom(first, twin, side);
      if (!hasTwoSides(part, twin, side)) continue;
      const int lesser = lesserSide(part, side);
      for (const std::uint32_t t : part) {
        if (side[t] != lesser) continue;
        std::swap(facets_.triangles[t][1], facets_.triangles[t][2]);
        if (count++ == 0) place = at(facets_.triangles[t][0]);
      }
    }
    note(count, "triangles were reversed to match their neighbours", place);
  }

  std::vector<std::uint32_t> partFrom(std::uint32_t first, const std::vector<HalfEdge>& twin,
                                      std::vector<int>& side) const {
    std::vector<std::uint32_t> part{first};
    side[first] = 1;
    for (std::size_t i = 0; i < part.size(); ++i)
      for (HalfEdge h = 3 * part[i]; h < 3 * part[i] + 3; ++h) {
        if (twin[h] == kNoHalfEdge || side[twin[h] / 3] != 0) continue;
        side[twin[h] / 3] = startOf(h) == startOf(twin[h]) ? -side[part[i]] : side[part[i]];
        part.push_back(twin[h] / 3);
      }
    return part;
  }

  bool hasTwoSides(const std::vector<std::uint32_t>& part, const std::vector<HalfEdge>& twin,
                   const std::vector<int>& side) const {
    return std::ranges::all_of(part, [&](std::uint32_t t) {
      for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
        if (twin[h] == kNoHalfEdge) continue;
        const bool isAgainst = startOf(h) == startOf(twin[h]);
        if ((side[t] == side[twin[h] / 3]) == isAgainst) return false;
      }
      return true;
    });
  }

  int lesserSide(const std::vector<std::uint32_t>& part, const std::vector<int>& side) const {
    double balance = 0;
    for (const std::uint32_t t : part) balance += side[t] * areaOf(facets_, t);
    return balance >= 0 ? -1 : 1;
  }

  Facets& facets_;
  double diagonal_, tolerance_;
  std::size_t twins_ = 0;
  std::optional<Point3> twinPlace_;
};

}  // namespace

void repairFacets(Facets& facets) { Repair(facets).repair(); }

}  // namespace af2::geometry
