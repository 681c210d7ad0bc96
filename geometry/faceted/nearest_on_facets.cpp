#include "geometry/faceted/nearest_on_facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "geometry/base/box_tree.h"
#include "geometry/faceted/nearest_in_triangle.h"

namespace af2::geometry {
namespace {

std::array<Point3, 3> cornersOf(const Facets& facets, std::uint32_t triangle) {
  const auto& [a, b, c] = facets.triangles[triangle];
  return {facets.vertices[a], facets.vertices[b], facets.vertices[c]};
}

std::vector<Box3> boxesAround(const Facets& facets) {
  std::vector<Box3> boxes(facets.triangles.size());
  for (std::uint32_t t = 0; t < boxes.size(); ++t)
    for (const Point3& corner : cornersOf(facets, t)) boxes[t].add(corner);
  return boxes;
}

}  // namespace

std::vector<PointOnFacets> nearestPoints(const Facets& facets, std::span<const Point3> points,
                                         int threads) {
  if (facets.triangles.empty()) throw InputError("the surface has no triangles");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const auto& [x, y, z] = points[i]; !std::isfinite(x + y + z))
      throw InputError("point " + std::to_string(i) + " has a coordinate that is no finite number");
  const BoxTree tree(boxesAround(facets));
  const auto footIn = [&](const Point3& p, std::uint32_t triangle) {
    const auto [a, b, c] = cornersOf(facets, triangle);
    const Barycentric w = nearestIn(p, a, b, c);
    return w.a * a + w.b * b + w.c * c;
  };
  constexpr std::size_t kAtOnce = 1024;
  std::vector<PointOnFacets> nearest(points.size());
  forEachInRanges(points.size(), kAtOnce, threads, [&](std::size_t i) {
    const Point3& p = points[i];
    const std::uint32_t t =
        tree.nearest(p, std::numeric_limits<double>::infinity(),
                     [&](std::uint32_t other) { return distance(p, footIn(p, other)); });
    const auto [a, b, c] = cornersOf(facets, t);
    nearest[i] = {footIn(p, t), unit(cross(b - a, c - a)), t};
  });
  return nearest;
}

}  // namespace af2::geometry
