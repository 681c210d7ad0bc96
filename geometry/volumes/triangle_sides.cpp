#include "geometry/volumes/triangle_sides.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "engine/base/elementary.h"
#include "geometry/base/disjoint_sets.h"

namespace af2::geometry {
namespace {

/// A triangle at an edge, which runs from its lower vertex to its higher one.
struct TriangleAtEdge {
  std::uint32_t high = 0;  ///< the higher vertex
  std::uint32_t triangle = 0;
  std::uint32_t opposite = 0;  ///< the third vertex
  bool isAlong = true;         ///< whether the triangle has the edge in this direction
  double angle = 0;            ///< of the triangle around the edge; only where several meet

  /// Sides that look to larger and to smaller angles around the edge.
  std::uint32_t forwardSide() const { return 2 * triangle + !isAlong; }
  std::uint32_t backwardSide() const { return 2 * triangle + isAlong; }
};

/// By the lower vertex of an edge.
class EdgesByVertex {
 public:
  EdgesByVertex(std::size_t vertices, const std::vector<Triangle>& triangles)
      : first_(vertices + 1, 0), all_(3 * triangles.size()) {
    for (const Triangle& triangle : triangles)
      for (std::size_t i = 0; i < 3; ++i)
        ++first_[std::min(triangle[i], triangle[(i + 1) % 3]).value + 1];
    for (std::size_t v = 0; v < vertices; ++v) first_[v + 1] += first_[v];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId from = triangles[t][i], to = triangles[t][(i + 1) % 3];
        all_[next[std::min(from, to).value]++] = {std::max(from, to).value, t,
                                                  triangles[t][(i + 2) % 3].value, from < to};
      }
  }

  std::span<TriangleAtEdge> at(std::size_t vertex) {
    return std::span(all_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<TriangleAtEdge> all_;
};

/// Sorts triangles by their angles around the edge.
void sortAround(const Point3& from, const Point3& to, const std::vector<Point3>& vertices,
                std::span<TriangleAtEdge> around) {
  const Point3 axis = unit(to - from);
  const auto across = [&](const TriangleAtEdge& triangle) {
    const Point3 way = vertices[triangle.opposite] - from;
    return way - dot(way, axis) * axis;
  };
  const Point3 zero = unit(across(around.front())), quarter = cross(axis, zero);
  for (TriangleAtEdge& triangle : around) {
    const Point3 way = across(triangle);
    triangle.angle = angleOf({dot(way, zero), dot(way, quarter)});
  }
  std::ranges::sort(around, {}, [](const TriangleAtEdge& triangle) {
    return std::tuple(triangle.angle, triangle.triangle);
  });
}

}  // namespace

std::vector<std::uint32_t> connectedSides(const std::vector<Point3>& vertices,
                                          const std::vector<Triangle>& triangles) {
  DisjointSets sides(2 * triangles.size());
  EdgesByVertex edges(vertices.size(), triangles);
  for (std::size_t low = 0; low < vertices.size(); ++low) {
    std::span<TriangleAtEdge> left = edges.at(low);
    std::ranges::sort(left, {}, [](const TriangleAtEdge& triangle) {
      return std::tuple(triangle.high, triangle.triangle);
    });
    while (!left.empty()) {
      const std::uint32_t high = left.front().high;
      const auto end = std::ranges::find_if(
          left, [&](const TriangleAtEdge& triangle) { return triangle.high != high; });
      const auto around = left.first(static_cast<std::size_t>(end - left.begin()));
      left = left.subspan(around.size());
      if (around.size() > 2) sortAround(vertices[low], vertices[high], vertices, around);
      for (std::size_t i = 0; i < around.size(); ++i)
        sides.join(around[i].forwardSide(), around[(i + 1) % around.size()].backwardSide());
    }
  }
  std::vector<std::uint32_t> lowest(2 * triangles.size());
  for (std::uint32_t side = 0; side < lowest.size(); ++side) lowest[side] = sides.of(side);
  return lowest;
}

}  // namespace af2::geometry
