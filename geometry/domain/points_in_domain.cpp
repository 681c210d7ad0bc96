#include "geometry/domain/points_in_domain.h"

#include <algorithm>
#include <string>

#include "engine/base/error.h"
#include "geometry/domain/points_on_curve.h"

namespace af2::geometry {
namespace {

/// A curve from one end to the other, without the last point.
void addCurve(const DomainCurve& curve, bool isReversed, const DomainFace& face,
              std::vector<Point2>& polygon) {
  constexpr int kPieces = 8;  // between knots, where the curve is nearly straight
  const std::size_t first = polygon.size();
  const auto add = [&](double parameter) {
    const SurfacePoint point = face.nearest(curve.pointAt(parameter));
    polygon.push_back({point.u, point.v});
  };
  for (std::size_t k = 1; k < curve.knots.size(); ++k)
    for (int i = 0; i < kPieces; ++i)
      add(curve.knots[k - 1] + i * (curve.knots[k] - curve.knots[k - 1]) / kPieces);
  if (!isReversed) return;
  add(curve.knots.back());
  polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(first));
  std::reverse(polygon.begin() + static_cast<std::ptrdiff_t>(first), polygon.end());
}

std::vector<std::vector<Point2>> loopsOf(const DomainModel& model, const DomainFace& face) {
  std::vector<std::vector<Point2>> loops;
  for (const std::vector<CurveUse>& loop : face.loops) {
    std::vector<Point2>& polygon = loops.emplace_back();
    for (const CurveUse& use : loop) addCurve(model.curves[use.curve], use.reversed, face, polygon);
  }
  return loops;
}

/// Whether the ray from p in the direction of x crosses the edge.
bool isCrossed(Point2 p, Point2 from, Point2 to) {
  return (from.y > p.y) != (to.y > p.y) &&
         p.x < from.x + (p.y - from.y) / (to.y - from.y) * (to.x - from.x);
}

}  // namespace

PointsInDomain::PointsInDomain(const DomainModel& model) : model_(model) {
  for (const DomainFace& face : model.faces) {
    const bool goesOn = face.surface->isPlane() || face.surface->inParameters() != nullptr;
    loops_.push_back(goesOn ? loopsOf(model, face) : std::vector<Polygon>{});
  }
}

const DomainFace& PointsInDomain::faceOf(int face) const {
  if (face < 1 || static_cast<std::size_t>(face) > model_.faces.size())
    throw InputError("there is no face " + std::to_string(face) + "; the model has faces 1 to " +
                     std::to_string(model_.faces.size()));
  return model_.faces[static_cast<std::size_t>(face) - 1];
}

SurfacePoint PointsInDomain::at(int face, double u, double v) const {
  return faceOf(face).surface->at(u, v);
}

bool PointsInDomain::isInside(int face, Point2 parameters) const {
  const auto& loops = loops_[static_cast<std::size_t>(face) - 1];
  bool isIn = loops.empty();
  for (const Polygon& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (isCrossed(parameters, loop[i], loop[(i + 1) % loop.size()])) isIn = !isIn;
  return isIn;
}

PointInDomain PointsInDomain::onFace(const Point3& point, int id) const {
  const DomainFace& face = faceOf(id);
  const SurfacePoint foot = face.nearest(point);
  if (isInside(id, {foot.u, foot.v})) return {foot, id, distance(point, foot.position)};
  PointInDomain best;
  for (const std::vector<CurveUse>& loop : face.loops) {
    for (const CurveUse& use : loop) {
      const DomainCurve& curve = model_.curves[use.curve];
      const CurveFoot onCurve = footOn(curve, point);
      if (best.face != 0 && onCurve.distance >= best.distance) continue;
      best = {face.nearest(curve.pointAt(onCurve.parameter)), id, onCurve.distance};
    }
  }
  return best;
}

PointInDomain PointsInDomain::nearest(const Point3& point, int face) const {
  if (face != 0) return onFace(point, face);
  PointInDomain best;
  for (int id = 1; id <= static_cast<int>(model_.faces.size()); ++id) {
    const PointInDomain here = onFace(point, id);
    if (here.face != 0 && (best.face == 0 || here.distance < best.distance)) best = here;
  }
  return best;
}

}  // namespace af2::geometry
