#include "geometry/check/triangle_pair.h"

#include <algorithm>
#include <cmath>

#include "engine/base/elementary.h"

namespace af2::geometry {

namespace {

struct Range {
  double low, high;
};

Range along(const Point3& axis, const Corners& corners) {
  const double a = dot(axis, corners[0]), b = dot(axis, corners[1]), c = dot(axis, corners[2]);
  return {std::min({a, b, c}), std::max({a, b, c})};
}

/// An axis without length separates nothing.
bool separates(const Point3& axis, const Corners& p, const Corners& q, double depth) {
  const double size = length(axis);
  if (!(size > 0)) return false;
  const Range onP = along(axis, p), onQ = along(axis, q);
  return std::min(onP.high - onQ.low, onQ.high - onP.low) <= depth * size;
}

Corners edgesOf(const Corners& c) { return {c[1] - c[0], c[2] - c[1], c[0] - c[2]}; }

bool isInPlane(const Corners& q, const Point3& origin, const Point3& normal, double depth) {
  const double limit = depth * length(normal);
  return std::ranges::all_of(
      q, [&](const Point3& corner) { return std::abs(dot(normal, corner - origin)) <= limit; });
}

bool anyEdgeNormalSeparates(const Corners& edges, const Point3& normal, const Corners& p,
                            const Corners& q, double depth) {
  return std::ranges::any_of(
      edges, [&](const Point3& edge) { return separates(cross(normal, edge), p, q, depth); });
}

}  // namespace

bool reachIntoEachOther(const Corners& p, const Corners& q, double depth) {
  const Corners edgesP = edgesOf(p), edgesQ = edgesOf(q);
  const Point3 normalP = cross(edgesP[0], edgesP[1]), normalQ = cross(edgesQ[0], edgesQ[1]);
  // If both are in one plane, only directions in the plane can separate them.
  const bool isFlat = isInPlane(q, p[0], normalP, depth);
  if (!isFlat && (separates(normalP, p, q, depth) || separates(normalQ, p, q, depth))) return false;
  if (anyEdgeNormalSeparates(edgesP, normalP, p, q, depth)) return false;
  if (anyEdgeNormalSeparates(edgesQ, normalQ, p, q, depth)) return false;
  if (isFlat) return true;
  for (const Point3& edgeP : edgesP)
    for (const Point3& edgeQ : edgesQ)
      if (separates(cross(edgeP, edgeQ), p, q, depth)) return false;
  return true;
}

bool areFolded(const Point3& a, const Point3& b, const Point3& c, const Point3& d, double angle) {
  const Point3 edge = unit(b - a);
  const auto across = [&](const Point3& corner) {
    const Point3 way = corner - a;
    return way - dot(way, edge) * edge;
  };
  const Point3 one = across(c), other = across(d);
  return angleBetween(one, other) < angle;
}

}  // namespace af2::geometry
