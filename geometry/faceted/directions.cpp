#include "geometry/faceted/directions.h"

#include <algorithm>

#include "geometry/faceted/noise.h"

namespace af2::geometry {
namespace {

/// The longest side of a triangle whose third corner is close to it; else none.
HalfEdge baseOfCap(const Facets& facets, std::uint32_t t) {
  constexpr double kFlat = 0.01, kFromEnds = 0.05;  // in lengths of the side
  const HalfEdge base = std::max({3 * t, 3 * t + 1, 3 * t + 2}, [&](HalfEdge g, HalfEdge h) {
    return lengthOf(facets, g) < lengthOf(facets, h);
  });
  const auto at = [&](HalfEdge h) { return facets.vertices[startOf(facets.triangles, h)]; };
  const Point3 from = at(base);
  const Point3 along = at(nextIn(base)) - from;
  const Point3 apex = at(previousIn(base)) - from;
  const double square = dot(along, along), within = dot(apex, along) / square;
  const bool isFlat = length(cross(along, apex)) < kFlat * square;
  return isFlat && within > kFromEnds && within < 1 - kFromEnds ? base : kNoHalfEdge;
}

/// A triangle with a corner close to the opposite side looks to where rounding and noise let it;
/// the one across that side knows better.
std::vector<Point3> normalsOf(const Facets& facets, const std::vector<HalfEdge>& twins) {
  std::vector<Point3> own;
  for (const auto& t : facets.triangles) {
    const Point3& origin = facets.vertices[t[0]];
    own.push_back(unit(cross(facets.vertices[t[1]] - origin, facets.vertices[t[2]] - origin)));
  }
  std::vector<Point3> normals = own;
  for (std::uint32_t t = 0; t < normals.size(); ++t) {
    const HalfEdge base = baseOfCap(facets, t);
    if (base == kNoHalfEdge || twins[base] == kNoHalfEdge) continue;
    const std::uint32_t other = twins[base] / 3;
    if (baseOfCap(facets, other) == kNoHalfEdge) normals[t] = own[other];
  }
  return normals;
}

}  // namespace

FacetDirections directionsOf(const Facets& facets,
                             const std::function<double(const Point3&)>& sizeAt) {
  const std::vector<HalfEdge> twins = orientedTwins(facets.triangles);
  return withoutNoise(facets, twins, normalsOf(facets, twins), sizeAt);
}

}  // namespace af2::geometry
