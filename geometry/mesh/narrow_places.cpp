#include "geometry/mesh/narrow_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "engine/base/parallel.h"
#include "geometry/base/box_tree.h"
#include "geometry/base/nearest_on_segment.h"

namespace af2::geometry {
namespace {

/// Least cosine between what faces each other across a narrow place: about 37 degrees.
constexpr double kFacing = 0.8;
/// Least cosine between the way across a strip and the direction straight into it.
constexpr double kAcross = 0.7;

/// An edge of an element on the boundary of its face.
struct Rim {
  VertexId from, to;
  int face = 0;
  Point3 inward;  ///< across the edge, in the plane of the element
};

Point3 normalOf(const ModelMesh& mesh, const Element& element) {
  const auto at = [&](std::size_t i) { return mesh.vertices[element.corners[i].value]; };
  return element.isQuad() ? unit(cross(at(2) - at(0), at(3) - at(1)))
                          : unit(cross(at(1) - at(0), at(2) - at(0)));
}

/// Distance along a ray to a triangle, if it hits.
std::optional<double> hitOf(const Point3& start, const Point3& direction, const Point3& a,
                            const Point3& b, const Point3& c) {
  const Point3 u = b - a, v = c - a, p = cross(direction, v);
  const double det = dot(u, p);
  if (det == 0) return std::nullopt;
  const Point3 s = start - a, q = cross(s, u);
  const double x = dot(s, p) / det, y = dot(direction, q) / det, t = dot(v, q) / det;
  if (x < 0 || y < 0 || x + y > 1 || t <= 0) return std::nullopt;
  return t;
}

class Finder {
 public:
  Finder(const ModelMesh& mesh, double elementsAcross, int threads)
      : mesh_(mesh), across_(elementsAcross), threads_(threads) {}

  std::vector<SizeSource> find() {
    findRims();
    findStrips();
    findGaps();
    return std::move(sources_);
  }

 private:
  const Point3& at(VertexId v) const { return mesh_.vertices[v.value]; }
  double wanted(VertexId v) const { return mesh_.wantedSizes[v.value]; }

  void findRims() {
    std::set<std::pair<VertexId, VertexId>> boundary;
    for (const EdgeSegment& s : mesh_.segments) boundary.insert(std::minmax(s.from, s.to));
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      const auto corners = mesh_.elements[e].vertices();
      const Point3 normal = normalOf(mesh_, mesh_.elements[e]);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const VertexId from = corners[i], to = corners[(i + 1) % corners.size()];
        if (!boundary.contains(std::minmax(from, to))) continue;
        rims_.push_back({from, to, mesh_.face[e], unit(cross(normal, at(to) - at(from)))});
      }
    }
  }

  using Sources = std::vector<SizeSource>;

  /// Adds what find(i, sources) adds for each of `count`, in their order.
  template <class Find>
  void findAll(std::size_t count, const Find& find) {
    constexpr std::size_t kAtOnce = 4096;
    const Ranges ranges(count, kAtOnce);
    std::vector<Sources> parts(ranges.count());
    forEachInParallel(parts.size(), threads_, [&](std::size_t part) {
      for (const std::size_t i : ranges[part]) find(i, parts[part]);
    });
    for (const Sources& part : parts) sources_.insert(sources_.end(), part.begin(), part.end());
  }

  /// `width` is how far it is to the other side of a narrow place; `corner` is on the rim of what
  /// was measured.
  void add(const Point3& place, const Point3& corner, double width, double wantedThere,
           Sources& sources) const {
    if (width > 0 && width < across_ * wantedThere)
      sources.push_back({place, width / across_, distance(place, corner)});
  }

  void findStrips() {
    std::vector<Box3> boxes;
    for (const Rim& rim : rims_) {
      boxes.emplace_back();
      boxes.back().add(at(rim.from));
      boxes.back().add(at(rim.to));
    }
    const BoxTree tree(boxes);
    findAll(rims_.size(), [&](std::size_t i, Sources& found) { findStrip(rims_[i], tree, found); });
  }

  void findStrip(const Rim& rim, const BoxTree& tree, Sources& found) const {
    const Point3 middle = 0.5 * (at(rim.from) + at(rim.to));
    const double size = std::min(wanted(rim.from), wanted(rim.to));
    const double reach = across_ * size;
    Box3 near;
    near.add(middle + Point3{reach, reach, reach});
    near.add(middle - Point3{reach, reach, reach});
    double width = reach;
    tree.forEachIn(
        near, [&](std::uint32_t i) { width = std::min(width, widthTo(rim, middle, rims_[i])); });
    add(middle, at(rim.from), width, size, found);
  }

  double widthTo(const Rim& rim, const Point3& middle, const Rim& other) const {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    if (other.face != rim.face || dot(other.inward, rim.inward) > -kFacing) return kNone;
    if (other.from == rim.from || other.from == rim.to || other.to == rim.from ||
        other.to == rim.to)
      return kNone;
    const Point3 way = nearestOnSegment(middle, at(other.from), at(other.to)) - middle;
    return dot(way, rim.inward) >= kAcross * length(way) ? length(way) : kNone;
  }

  void findGaps() {
    std::vector<Box3> boxes;
    for (const Element& element : mesh_.elements) {
      boxes.emplace_back();
      for (const VertexId v : element.vertices()) boxes.back().add(at(v));
    }
    const BoxTree tree(boxes);
    findAll(mesh_.elements.size(),
            [&](std::size_t i, Sources& found) { findGap(mesh_.elements[i], tree, found); });
  }

  void findGap(const Element& element, const BoxTree& tree, Sources& found) const {
    const auto corners = element.vertices();
    Point3 middle;
    double size = std::numeric_limits<double>::infinity();
    for (const VertexId v : corners) {
      middle = middle + (1.0 / element.size()) * at(v);
      size = std::min(size, wanted(v));
    }
    const Point3 normal = normalOf(mesh_, element);
    double width = across_ * size;
    for (const Point3& direction : {normal, -1 * normal}) {
      Box3 way;
      way.add(middle);
      way.add(middle + width * direction);
      tree.forEachIn(way, [&](std::uint32_t i) {
        const Element& other = mesh_.elements[i];
        if (std::abs(dot(normalOf(mesh_, other), normal)) < kFacing) return;
        if (meet(corners, other.vertices())) return;
        width = std::min(width, distanceAlong(middle, direction, other).value_or(width));
      });
    }
    add(middle, at(corners[0]), width, size, found);
  }

  static bool meet(std::span<const VertexId> a, std::span<const VertexId> b) {
    return std::ranges::any_of(a, [&](VertexId v) { return std::ranges::count(b, v) > 0; });
  }

  std::optional<double> distanceAlong(const Point3& start, const Point3& direction,
                                      const Element& other) const {
    const auto corner = [&](std::size_t i) { return at(other.corners[i]); };
    if (const auto hit = hitOf(start, direction, corner(0), corner(1), corner(2))) return hit;
    if (!other.isQuad()) return std::nullopt;
    return hitOf(start, direction, corner(0), corner(2), corner(3));
  }

  const ModelMesh& mesh_;
  double across_;
  std::vector<Rim> rims_;
  Sources sources_;
  int threads_;
};

}  // namespace

std::vector<SizeSource> narrowPlaces(const ModelMesh& mesh, double elementsAcross, int threads) {
  return Finder(mesh, elementsAcross, threads).find();
}

}  // namespace af2::geometry
