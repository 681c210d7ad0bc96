#include "geometry/faceted/facet_layout.h"

#include <algorithm>
#include <limits>

namespace af2::geometry {
namespace {

Metric sum(const Metric& m, double factor, const Metric& n) {
  return {m.uu + factor * n.uu, m.uv + factor * n.uv, m.vv + factor * n.vv};
}

/// The point of a segment that is nearest to a place: 0 is its start, 1 its end.
double nearestOn(Point2 from, Point2 to, Point2 place) {
  const Point2 along = to - from;
  const double square = dot(along, along);
  return square > 0 ? std::clamp(dot(place - from, along) / square, 0.0, 1.0) : 0;
}

}  // namespace

FacetLayout::FacetLayout(std::vector<Point2> places, const std::vector<Point3>& vertices,
                         const std::vector<Corners>& triangles)
    : places_(std::move(places)), triangles_(triangles), tree_(takeMetrics(vertices)) {}

std::vector<Box3> FacetLayout::takeMetrics(const std::vector<Point3>& vertices) {
  std::vector<Box3> boxes;
  std::vector<double> areas(vertices.size(), 0);
  metrics_.assign(vertices.size(), {});
  for (const Corners& t : triangles_) {
    Box3& box = boxes.emplace_back();
    for (const std::uint32_t v : t) box.add(Point3{places_[v].x, places_[v].y, 0});
    const Point2 p = places_[t[1]] - places_[t[0]], q = places_[t[2]] - places_[t[0]];
    const Point3 a = vertices[t[1]] - vertices[t[0]], b = vertices[t[2]] - vertices[t[0]];
    const double area = cross(p, q);
    if (!(area > 0)) continue;  // too thin for rounding
    const Point3 du = (1 / area) * (q.y * a - p.y * b), dv = (1 / area) * (p.x * b - q.x * a);
    for (const std::uint32_t v : t) {
      metrics_[v] = sum(metrics_[v], area, {dot(du, du), dot(du, dv), dot(dv, dv)});
      areas[v] += area;
    }
  }
  for (std::size_t v = 0; v < metrics_.size(); ++v)
    if (areas[v] > 0) metrics_[v] = sum({}, 1 / areas[v], metrics_[v]);
  return boxes;
}

bool FacetLayout::contains(std::uint32_t triangle, Point2 place) const {
  const auto& [a, b, c] = triangles_[triangle];
  const Point2 pa = places_[a] - place, pb = places_[b] - place, pc = places_[c] - place;
  return (cross(pa, pb) >= 0) & (cross(pb, pc) >= 0) & (cross(pc, pa) >= 0) &
         (cross(pb - pa, pc - pa) > 0);
}

Barycentric FacetLayout::weightsIn(std::uint32_t triangle, Point2 place) const {
  const auto& [a, b, c] = triangles_[triangle];
  const Point2 pa = places_[a], pb = places_[b], pc = places_[c];
  const double whole = cross(pb - pa, pc - pa);
  return {cross(pb - place, pc - place) / whole, cross(pc - place, pa - place) / whole,
          cross(pa - place, pb - place) / whole};
}

Barycentric FacetLayout::nearestIn(std::uint32_t triangle, Point2 place) const {
  if (contains(triangle, place)) return weightsIn(triangle, place);
  const auto& [a, b, c] = triangles_[triangle];
  const Point2 pa = places_[a], pb = places_[b], pc = places_[c];
  const double ab = nearestOn(pa, pb, place), bc = nearestOn(pb, pc, place),
               ca = nearestOn(pc, pa, place);
  const double toAb = distance(pa + ab * (pb - pa), place),
               toBc = distance(pb + bc * (pc - pb), place),
               toCa = distance(pc + ca * (pa - pc), place);
  if (toAb <= toBc && toAb <= toCa) return {1 - ab, ab, 0};
  if (toBc <= toCa) return {0, 1 - bc, bc};
  return {ca, 0, 1 - ca};
}

FacetLayout::Found FacetLayout::at(Point2 place) const {
  const Point3 p{place.x, place.y, 0};
  Found found;
  found.triangle = tree_.firstAt(p, [&](std::uint32_t t) { return contains(t, place); });
  if (found.triangle != BoxTree::kNone) return {found.triangle, weightsIn(found.triangle, place)};
  found.triangle = tree_.nearest(p, std::numeric_limits<double>::infinity(), [&](std::uint32_t t) {
    return distance(placeIn(t, nearestIn(t, place)), place);
  });
  found.where = nearestIn(found.triangle, place);
  return found;
}

Point2 FacetLayout::placeIn(std::uint32_t triangle, const Barycentric& where) const {
  const auto& [a, b, c] = triangles_[triangle];
  return where.a * places_[a] + where.b * places_[b] + where.c * places_[c];
}

Metric FacetLayout::metricAt(const Found& found) const {
  const auto& [a, b, c] = triangles_[found.triangle];
  const auto& [wa, wb, wc] = found.where;
  return sum(sum(sum({}, wa, metrics_[a]), wb, metrics_[b]), wc, metrics_[c]);
}

}  // namespace af2::geometry
