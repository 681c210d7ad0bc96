#include "geometry/occ/surfaces/sharp_tips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/base/elementary.h"

namespace af2::geometry {

namespace {

constexpr double kNear = 0.0025;  // share of the way from a side to the other

/// Points along one side of the parameters, or along a line a share of the way from it to the
/// other side.
std::vector<SurfacePoint> alongSide(const GeneralSurface& surface, const SplineSurface::Box& box,
                                    int side, double share) {
  constexpr int kSteps = 8;
  std::vector<SurfacePoint> points;
  const double inward = side % 2 == 0 ? share : 1 - share;
  for (int i = 0; i <= kSteps; ++i) {
    const double along = static_cast<double>(i) / kSteps;
    const auto [x, y] = side < 2 ? std::array{along, inward} : std::array{inward, along};
    points.push_back(
        surface.pointAt(box.u1 + x * (box.u2 - box.u1), box.v1 + y * (box.v2 - box.v1)));
  }
  return points;
}

double reachFromStart(const std::vector<SurfacePoint>& points) {
  double extent = 0;
  for (const SurfacePoint& point : points)
    extent = std::max(extent, distance(point.position, points.front().position));
  return extent;
}

double spreadOfNormals(const std::vector<SurfacePoint>& points) {
  double spread = 0;
  for (const SurfacePoint& p : points)
    for (const SurfacePoint& q : points) spread = std::max(spread, distance(p.normal, q.normal));
  return spread;
}

/// The ends of a line once around are the same place, and count half.
Point3 meanNormal(const std::vector<SurfacePoint>& points) {
  Point3 sum = -0.5 * (points.front().normal + points.back().normal);
  for (const SurfacePoint& point : points) sum = sum + point.normal;
  constexpr double kNone = 1e-3;
  return length(sum) > kNone ? unit(sum) : Point3{};
}

/// How far around the tip at one side of the parameters the surface goes, and how far its normals
/// turn on the way.
struct Around {
  double angle = 0, turn = 0;
};
Around aroundTip(const GeneralSurface& surface, const SplineSurface::Box& box, int side) {
  const auto points = alongSide(surface, box, side, kNear);
  const Point3 tip = alongSide(surface, box, side, 0).front().position;
  Around around;
  for (std::size_t i = 1; i < points.size(); ++i) {
    around.angle += 2 * distance(points[i].position, points[i - 1].position) /
                    (distance(points[i].position, tip) + distance(points[i - 1].position, tip));
    around.turn += distance(points[i].normal, points[i - 1].normal);
  }
  return around;
}

/// At the pole of a dome normals come together, and the spread is in proportion to the distance.
bool isSharp(const GeneralSurface& surface, const SplineSurface::Box& box, int side) {
  constexpr double kFar = 4 * kNear;
  constexpr double kSharp = 0.35;  // 20 degrees
  constexpr double kLasting = 0.7;
  const double near = spreadOfNormals(alongSide(surface, box, side, kNear));
  const double far = spreadOfNormals(alongSide(surface, box, side, kFar));
  return near > kSharp && near > kLasting * far;
}

}  // namespace

SharpTips::SharpTips(const GeneralSurface& surface, const SplineSurface::Box& box) {
  constexpr double kPoint = 1e-6;  // of the extent in the middle
  for (int side = 0; side < 4; ++side) {
    const auto points = alongSide(surface, box, side, 0);
    const double slack = kPoint * reachFromStart(alongSide(surface, box, side, 0.5));
    if (reachFromStart(points) >= slack || !isSharp(surface, box, side)) continue;
    const auto [angle, turn] = aroundTip(surface, box, side);
    const double halfAngle = angleOf({turn, angle});  // of the cone that is as sharp
    const bool isAlongU = side < 2;
    const double length = isAlongU ? box.u2 - box.u1 : box.v2 - box.v1;
    tips_.push_back({{points.front().position, slack, 2 * std::numbers::pi * sine(halfAngle)},
                     meanNormal(alongSide(surface, box, side, kNear)),
                     isAlongU,
                     angle / length});
  }
}

const SharpTips::Tip* SharpTips::tipAt(const Point3& position, double times) const {
  const auto found = std::ranges::find_if(
      tips_, [&](const Tip& tip) { return distance(position, tip.position) < times * tip.slack; });
  return found == tips_.end() ? nullptr : &*found;
}

double SharpTips::easing(const Point3& position, double reach) const {
  double easing = 1;
  for (const Tip& tip : tips_) {
    const double away = distance(position, tip.position);
    if (away < reach) easing = std::max(easing, reach / std::max(away, tip.slack));
  }
  return easing;
}

std::optional<double> SharpTips::radiusAtTip(const Point3& position, double reach) const {
  constexpr double kBlurred = 1000;  // nearer, second derivatives are not to be trusted
  const Tip* tip = tipAt(position, kBlurred);
  if (!tip) return std::nullopt;
  const double sine = tip->angle / (2 * std::numbers::pi);  // of the angle from the axis
  return reach * sine / std::sqrt(1 - sine * sine);
}

std::optional<Point3> SharpTips::normalAt(const Point3& position) const {
  const Tip* tip = tipAt(position);
  return tip && length(tip->normal) > 0 ? std::optional(tip->normal) : std::nullopt;
}

double SharpTips::angleBetween(const SurfacePoint& from, const SurfacePoint& to,
                               const Point3& position) const {
  const Tip* tip = tipAt(position);
  return tip ? tip->perLength * std::abs(tip->isAlongU ? from.u - to.u : from.v - to.v) : 0;
}

}  // namespace af2::geometry
