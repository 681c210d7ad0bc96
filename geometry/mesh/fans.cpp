#include "geometry/mesh/fans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/error.h"
#include "engine/mesh/element_shape.h"

namespace af2::geometry {

namespace {

double distortionOf(const Mesh& mesh, const Element& element) {
  std::array<const SurfacePoint*, 4> corners{};
  std::size_t n = 0;
  for (const VertexId v : element.vertices()) corners[n++] = &mesh.vertices[v.value];
  return elementDistortion(std::span(corners).first(n));
}

/// The mesh has the vertices of the fan.
std::vector<Element> elementsOf(const std::vector<VertexId>& rim, VertexId tip, FanElements kind,
                                const Mesh& mesh) {
  std::vector<Element> elements;
  for (std::size_t i = 1; i < rim.size(); ++i) {
    if (kind == FanElements::Quads && i + 1 < rim.size()) {
      // The first diagonal, which divides the quadrilateral for other purposes, is that at the tip:
      // two quadrilaterals all around it have the corners of the other one in common.
      const Element quad{{rim[i], rim[i - 1], tip, rim[i + 1]}};
      if (std::isfinite(distortionOf(mesh, quad))) {
        elements.push_back(quad);
        ++i;
        continue;
      }
    }
    elements.push_back({{rim[i], rim[i - 1], tip}});
  }
  return elements;
}

/// The numbers of vertices when the tips have been inserted behind those of the boundary.
struct WithTips {
  std::uint32_t first, count;

  explicit WithTips(const FaceBoundary& boundary, std::size_t points)
      : first(static_cast<std::uint32_t>(points)),
        count(static_cast<std::uint32_t>(boundary.fans.size())) {}
  VertexId moved(VertexId v) const { return v.value < first ? v : VertexId(v.value + count); }
  VertexId tip(std::size_t fan) const { return VertexId(first + fan); }
};

/// Joins the two triangles on both sides of a side that ends at a tip.
class TipJoining {
 public:
  /// fixed  the number of vertices, from the first one on, that must not move
  TipJoining(Mesh& mesh, const AF2LocalTransformMaker& charts, std::size_t fixed)
      : mesh_(mesh), charts_(charts), fixed_(fixed) {}

  /// middle  the other end of the side, which moves
  void tryAt(VertexId middle, VertexId tip) {
    if (middle.value < fixed_) return;
    collectStar(middle);
    const std::optional<Pair> pair = pairAt(middle, tip);
    if (!pair) return;
    const SurfacePoint here = mesh_.vertices[middle.value];
    std::optional<SurfacePoint> best;
    double least = std::numeric_limits<double>::infinity();
    for (const SurfacePoint& place : placesBelow(middle, tip)) {
      mesh_.vertices[middle.value] = place;
      const double worst = worstDistortion(*pair);
      if (worst < least) {
        least = worst;
        best = place;
      }
    }
    mesh_.vertices[middle.value] = best.value_or(here);
    if (!best) return;
    mesh_.elements[pair->before] = pair->joined;
    gone_.push_back(pair->behind);
  }

  /// Removes the triangles that have become part of a quadrilateral. Returns their number.
  std::size_t finish() {
    std::ranges::sort(gone_, std::greater<>());
    for (const std::size_t e : gone_) {
      mesh_.elements.erase(mesh_.elements.begin() + static_cast<std::ptrdiff_t>(e));
      mesh_.origins.erase(mesh_.origins.begin() + static_cast<std::ptrdiff_t>(e));
    }
    return gone_.size();
  }

 private:
  struct Pair {
    std::size_t before, behind;  ///< triangles, counter-clockwise around the tip
    Element joined;
  };

  void collectStar(VertexId v) {
    star_.clear();
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
      if (std::ranges::count(mesh_.elements[e].vertices(), v) > 0 &&
          std::ranges::count(gone_, e) == 0)
        star_.push_back(e);
  }

  std::optional<Pair> pairAt(VertexId middle, VertexId tip) const {
    std::optional<std::size_t> before, behind;
    VertexId first, last;
    for (const std::size_t e : star_) {
      const Element& element = mesh_.elements[e];
      for (std::size_t i = 0; i < 3 && !element.isQuad(); ++i) {
        if (element.corners[i] != tip) continue;
        const VertexId next = element.corners[(i + 1) % 3], after = element.corners[(i + 2) % 3];
        if (after == middle) {
          before = e;
          first = next;
        } else if (next == middle) {
          behind = e;
          last = after;
        }
      }
    }
    if (!before || !behind || first == last) return std::nullopt;
    // The first diagonal is that at the tip, see elementsOf.
    return Pair{*before, *behind, {{middle, last, tip, first}}};
  }

  /// On the ways from the middle to the vertices around it that are farther from the tip.
  std::vector<SurfacePoint> placesBelow(VertexId middle, VertexId tip) const {
    const Point3 top = mesh_.vertices[tip.value].position;
    const SurfacePoint& here = mesh_.vertices[middle.value];
    std::vector<VertexId> around;
    for (const std::size_t e : star_) {
      const auto corners = mesh_.elements[e].vertices();
      around.insert(around.end(), corners.begin(), corners.end());
    }
    std::ranges::sort(around);
    around.erase(std::ranges::unique(around).begin(), around.end());
    std::vector<SurfacePoint> places;
    for (const VertexId v : around) {
      const SurfacePoint& there = mesh_.vertices[v.value];
      if (distance(there.position, top) > distance(here.position, top))
        addPlacesBetween(here, there, places);
    }
    return places;
  }

  void addPlacesBetween(const SurfacePoint& here, const SurfacePoint& there,
                        std::vector<SurfacePoint>& places) const {
    constexpr std::array kParts{0.125, 0.25, 0.375, 0.5, 0.625, 0.75};
    try {
      const auto chart =
          charts_.makeLocalTransform(here, there, distance(here.position, there.position));
      for (const double part : kParts)
        if (const auto place = chart->transformToSurface({part, 0})) places.push_back(*place);
    } catch (const GeometryError&) {  // there is no chart here
    }
  }

  double worstDistortion(const Pair& pair) const {
    double worst = distortionOf(mesh_, pair.joined);
    for (const std::size_t e : star_)
      if (e != pair.before && e != pair.behind)
        worst = std::max(worst, distortionOf(mesh_, mesh_.elements[e]));
    return worst;
  }

  Mesh& mesh_;
  const AF2LocalTransformMaker& charts_;
  std::size_t fixed_;
  std::vector<std::size_t> star_, gone_;
};

}  // namespace

double areaOfFans(const FaceBoundary& boundary) {
  if (boundary.fans.empty()) return 0;
  std::map<VertexId, Point3> positions;
  for (const auto& loop : boundary.input.loops)
    for (const BoundaryCorner& corner : loop) positions[corner.vertex] = corner.point.position;
  double area = 0;
  for (const FaceBoundary::Fan& fan : boundary.fans)
    for (std::size_t i = 1; i < fan.rim.size(); ++i)
      area += length(cross(positions[fan.rim[i - 1]] - fan.place.position,
                           positions[fan.rim[i]] - fan.place.position)) /
              2;
  return area;
}

void addFans(FaceBoundary& boundary, FanElements kind, ElementOrigin origin, Mesh& mesh) {
  if (boundary.fans.empty()) return;
  const WithTips numbers(boundary, boundary.points.size());
  for (Element& element : mesh.elements)
    for (int i = 0; i < element.size(); ++i) {
      VertexId& v = element.corners[static_cast<std::size_t>(i)];
      v = numbers.moved(v);
    }
  std::vector<SurfacePoint> tips;
  for (const FaceBoundary::Fan& fan : boundary.fans) tips.push_back(fan.place);
  mesh.vertices.insert(mesh.vertices.begin() + numbers.first, tips.begin(), tips.end());
  for (const FaceBoundary::Fan& fan : boundary.fans) {
    const VertexId tip(boundary.points.size());
    boundary.points.push_back(fan.tip);
    std::vector<VertexId> rim;
    for (const VertexId v : fan.rim) rim.push_back(numbers.moved(v));
    for (const Element& element : elementsOf(rim, tip, kind, mesh)) {
      mesh.elements.push_back(element);
      mesh.origins.push_back(origin);
    }
  }
}

std::size_t joinAtTips(const FaceBoundary& boundary, const AF2LocalTransformMaker& charts,
                       Mesh& mesh) {
  const WithTips numbers(boundary, boundary.points.size() - boundary.fans.size());
  TipJoining joining(mesh, charts, boundary.points.size());
  for (std::size_t i = 0; i < boundary.fans.size(); ++i)
    for (const VertexId v : boundary.fans[i].rim) joining.tryAt(numbers.moved(v), numbers.tip(i));
  return joining.finish();
}

MeshBoundary boundaryWithFans(const FaceBoundary& boundary) {
  MeshBoundary result = boundaryOf(boundary.input);
  const WithTips numbers(boundary, boundary.points.size() - boundary.fans.size());
  for (std::size_t i = 0; i < boundary.fans.size(); ++i) {
    const std::vector<VertexId>& rim = boundary.fans[i].rim;
    for (std::size_t k = 1; k < rim.size(); ++k)
      std::erase(result.edges, std::pair(rim[k - 1], rim[k]));
  }
  for (auto& [from, to] : result.edges) {
    from = numbers.moved(from);
    to = numbers.moved(to);
  }
  for (std::size_t i = 0; i < boundary.fans.size(); ++i) {
    const std::vector<VertexId>& rim = boundary.fans[i].rim;
    result.edges.emplace_back(numbers.moved(rim.front()), numbers.tip(i));
    result.edges.emplace_back(numbers.tip(i), numbers.moved(rim.back()));
  }
  std::ranges::sort(result.edges);
  result.fixedCount = boundary.points.size();
  return result;
}

}  // namespace af2::geometry
