#include "geometry/layers/surface_walk.h"

#include <cmath>

#include "engine/base/error.h"

namespace af2::geometry {
namespace {

/// A vector as part of the tangent plane at a point.
Point3 inTangentPlane(const Point3& vector, const SurfacePoint& at) {
  return unit(vector - dot(vector, at.normal) * at.normal);
}

}  // namespace

SurfaceWalk::SurfaceWalk(const ChartedSurface& surface, const PlaceInParameters& place)
    : place_(place),
      charts_(surface.makeCharts(surface.isPlane() ? ChartKind::Plane : ChartKind::MeanNormal)) {}

std::vector<SurfacePoint> SurfaceWalk::along(const SurfacePoint& from, const Point3& direction,
                                             const std::vector<double>& distances) const {
  std::vector<SurfacePoint> points;
  SurfacePoint here = from;
  Point3 ahead = direction;
  double walked = 0;
  for (const double distance : distances) {
    const auto next = step(here, ahead, distance - walked, 0);
    if (!next) break;
    ahead = inTangentPlane(next->position - here.position, *next);
    here = place_(*next, here.u, here.v);
    points.push_back(here);
    walked = distance;
  }
  return points;
}

/// In a chart at the start, whose plane is tangential there. Where the surface turns, in halves.
std::optional<SurfacePoint> SurfaceWalk::step(const SurfacePoint& from, const Point3& direction,
                                              double length, int halvings) const {
  constexpr double kStraight = 0.995;  // cosine of the turn of a step, a tenth of a radian
  constexpr int kMaxHalvings = 6, kMaxRounds = 4;
  SurfacePoint towards = from;
  towards.position = from.position + length * direction;
  std::optional<SurfacePoint> hit;
  try {
    ChartSlot slot;
    const AF2LocalTransform& chart = charts_->makeLocalTransformIn(slot, from, towards, length);
    double x = 1;
    for (int round = 0; round < kMaxRounds; ++round) {
      hit = chart.transformToSurface({x, 0});
      if (!hit) break;
      const double ratio = length / distance(from.position, hit->position);
      if (std::abs(ratio - 1) < 1e-12) break;
      x *= ratio;
    }
  } catch (const GeometryError&) {
    hit.reset();
  }
  if (hit && dot(hit->normal, from.normal) >= kStraight) return hit;
  if (halvings == kMaxHalvings) return std::nullopt;
  const auto half = step(from, direction, length / 2, halvings + 1);
  if (!half) return std::nullopt;
  const SurfacePoint middle = place_(*half, from.u, from.v);
  const Point3 ahead = inTangentPlane(middle.position - from.position, middle);
  return step(middle, ahead, length / 2, halvings + 1);
}

/// Newton's method for the foot of the perpendicular, which is the point itself.
PlaceInParameters placeInParametersOf(const ChartedSurface& surface) {
  return [&surface](const SurfacePoint& point, double u, double v) {
    constexpr int kMaxSteps = 20;
    constexpr double kDegenerate = 1e-12;
    SurfacePoint placed = point;
    placed.u = u;
    placed.v = v;
    for (int i = 0; i < kMaxSteps; ++i) {
      const SurfaceFrame s = surface.inParameters()->frameAt(placed.u, placed.v);
      const Point3 r = point.position - s.position;
      const double e = dot(s.du, s.du), f = dot(s.du, s.dv), g = dot(s.dv, s.dv);
      const double det = e * g - f * f;
      if (!(det > kDegenerate * e * g)) break;
      const double a = dot(r, s.du), b = dot(r, s.dv);
      const double stepU = (g * a - f * b) / det, stepV = (e * b - f * a) / det;
      placed.u += stepU;
      placed.v += stepV;
      if (std::abs(stepU) <= 1e-14 * std::abs(placed.u) + 1e-300 &&
          std::abs(stepV) <= 1e-14 * std::abs(placed.v) + 1e-300)
        break;
    }
    return placed;
  };
}

}  // namespace af2::geometry
