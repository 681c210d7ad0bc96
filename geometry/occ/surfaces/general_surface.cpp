#include "geometry/occ/surfaces/general_surface.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_SweptSurface.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/base/turns.h"
#include "geometry/occ/base/points.h"

namespace af2::geometry {

namespace {

/// A new vertex lies exactly on the surface wherever Newton stops; this, in wanted edge lengths, is
/// only how far it may be from where the rule wants it.
constexpr double kPlaceTolerance = 2e-3;
constexpr int kMaxSteps = 12;

/// du x dv counts as zero below this sine of the angle between them, or where du or dv is shorter
/// than this share of its usual length. The two need not be alike: the one may be an angle, the
/// other a length in any unit.
constexpr double kDegenerate = 1e-6;
/// Near poles, where du or dv is shorter than this share, curvature is noise.
constexpr double kNearPole = 1e-3;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Smallest radius of normal curvature. `normal` is du x dv; the lengths are the usual ones of du
/// and dv.
double smallestRadius(const SurfaceJet& s, const Point3& normal, double lengthU, double lengthV) {
  const double e = dot(s.du, s.du), f = dot(s.du, s.dv), g = dot(s.dv, s.dv);
  const double det = e * g - f * f;
  const bool isRegular = std::sqrt(e) > kNearPole * lengthU && std::sqrt(g) > kNearPole * lengthV;
  if (!isRegular || !(det > kNearPole * kNearPole * e * g)) return kInfinite;
  const double size = std::sqrt(det);
  const double l = dot(s.duu, normal) / size, m = dot(s.duv, normal) / size,
               n = dot(s.dvv, normal) / size;
  const double mean = (e * n - 2 * f * m + g * l) / (2 * det);
  const double gauss = (l * n - m * m) / det;
  const double largest = std::abs(mean) + std::sqrt(std::max(0.0, mean * mean - gauss));
  return largest > 0 ? 1 / largest : kInfinite;
}

ParameterRange rangeOf(double low, double high, bool closed) {
  return {low, high, closed && !Precision::IsInfinite(low) && !Precision::IsInfinite(high)};
}

/// Whether the surface turns by much where a parameter comes back to where it started, as at the
/// trailing edge of a wing.
template <class At>
bool isSharpAtEnds(const ParameterRange& range, double from, double to, const At& normalAt) {
  constexpr double kBesideShare = 1e-6;  // of the width
  for (const double share : {0.02, 0.26, 0.5, 0.74, 0.98}) {
    const double at = from + share * (to - from), beside = kBesideShare * range.width();
    const Point3 first = normalAt(range.low + beside, at), last = normalAt(range.high - beside, at);
    if (differSharply(first, last)) return true;
  }
  return false;
}

/// A face that ends at the ends of a range does not go on beyond them.
bool endsWithin(const ParameterRange& range, double from, double to) {
  constexpr double kSlack = 1e-6;
  return from >= range.low - kSlack * range.width() && to <= range.high + kSlack * range.width();
}

/// A curve that is swept may have been trimmed to another part of it than the face takes up: it
/// goes on beyond its ends.
ParameterRange reaching(const ParameterRange& range, const Handle(Geom_Surface) & surface,
                        double from, double to) {
  const bool isSwept = surface->IsKind(STANDARD_TYPE(Geom_SweptSurface));
  return isSwept && !range.closed && !endsWithin(range, from, to) ? ParameterRange{from, to, false}
                                                                  : range;
}

/// Periodic splines come back to the other side beyond their ends.
Handle(Geom_Surface) withoutPeriods(const Handle(Geom_Surface) & surface, bool inU, bool inV) {
  const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface);
  if (spline.IsNull() || !((inU && spline->IsUPeriodic()) || (inV && spline->IsVPeriodic())))
    return surface;
  Handle(Geom_BSplineSurface) copy = Handle(Geom_BSplineSurface)::DownCast(spline->Copy());
  if (inU && copy->IsUPeriodic()) copy->SetUNotPeriodic();
  if (inV && copy->IsVPeriodic()) copy->SetVNotPeriodic();
  return Handle(Geom_Surface)(copy);
}

}  // namespace

double ParameterRange::bring(double value) const {
  if (!closed) return std::clamp(value, low, high);
  if (value >= low && value <= high) return value;
  return intoPeriod(value, low, width());
}

double ParameterRange::near(double value, double other) const {
  if (!closed) return value;
  return value - std::round((value - other) / width()) * width();
}

GeneralSurface::GeneralSurface(const Handle(Geom_Surface) & surface, bool flipped,
                               const SplineSurface::Box& box)
    : values_(surface, box), box_(box), sign_(flipped ? -1 : 1) {
  double u1, u2, v1, v2;
  surface->Bounds(u1, u2, v1, v2);
  u_ = reaching(rangeOf(u1, u2, surface->IsUClosed()), surface, box.u1, box.u2);
  v_ = reaching(rangeOf(v1, v2, surface->IsVClosed()), surface, box.v1, box.v2);
  openSharpEnds(surface);
  for (const double shareU : {0.1, 0.5, 0.9})
    for (const double shareV : {0.1, 0.5, 0.9}) {
      const Frame frame =
          frameAt(box.u1 + shareU * (box.u2 - box.u1), box.v1 + shareV * (box.v2 - box.v1));
      lengthU_ = std::max(lengthU_, length(frame.du));
      lengthV_ = std::max(lengthV_, length(frame.dv));
    }
}

void GeneralSurface::openSharpEnds(const Handle(Geom_Surface) & surface) {
  const auto normalAt = [&](double u, double v) {
    const Frame frame = values_.frameAt(u, v);
    return cross(frame.du, frame.dv);
  };
  const bool inU =
      u_.closed && endsWithin(u_, box_.u1, box_.u2) &&
      isSharpAtEnds(u_, box_.v1, box_.v2, [&](double u, double v) { return normalAt(u, v); });
  const bool inV =
      v_.closed && endsWithin(v_, box_.v1, box_.v2) &&
      isSharpAtEnds(v_, box_.u1, box_.u2, [&](double v, double u) { return normalAt(u, v); });
  if (!inU && !inV) return;
  values_ = SurfaceValues(withoutPeriods(surface, inU, inV), box_);
  u_.closed = u_.closed && !inU;
  v_.closed = v_.closed && !inV;
}

void GeneralSurface::endAtBox() {
  u_ = {box_.u1, box_.u2, false};
  v_ = {box_.v1, box_.v2, false};
}

SurfacePoint GeneralSurface::pointAt(double u, double v) const {
  const Frame frame = frameAt(u, v);
  const auto normal = unitNormal(frame);
  return {frame.position, normal ? *normal : normalAt(u, v), u, v};
}

std::optional<Point3> GeneralSurface::unitNormal(const Frame& frame) const {
  const Point3 normal = cross(frame.du, frame.dv);
  const double size = length(normal), u = length(frame.du), v = length(frame.dv);
  if (!(u > kDegenerate * lengthU_ && v > kDegenerate * lengthV_ && size > kDegenerate * u * v))
    return std::nullopt;
  return (sign_ / size) * normal;
}

Point3 GeneralSurface::normalAt(double u, double v) const {
  if (const auto normal = unitNormal(frameAt(u, v))) return *normal;
  // A pole: look a little way off in all directions that the range allows.
  for (const double step : {1e-4, 1e-3, 1e-2}) {
    Point3 sum;
    for (const auto& [a, b] : {std::array{-1.0, 0.0}, std::array{1.0, 0.0}, std::array{0.0, -1.0},
                               std::array{0.0, 1.0}, std::array{0.25, 0.5}, std::array{-0.25, 0.5},
                               std::array{0.25, -0.5}, std::array{-0.25, -0.5}}) {
      const double nearU = u_.bring(u + a * step * u_.width());
      const double nearV = v_.bring(v + b * step * v_.width());
      if (const auto normal = unitNormal(frameAt(nearU, nearV))) sum = sum + *normal;
    }
    if (length(sum) > kDegenerate) return unit(sum);
  }
  return {};
}

Point3 GeneralSurface::normalAtBoundary(double u, double v) const {
  constexpr double kStep = 0.01;        // of the way to the middle of the face
  constexpr double kDegenerated = 0.1;  // share of the area of du x dv
  const double innerU = u + kStep * ((box_.u1 + box_.u2) / 2 - u);
  const double innerV = v + kStep * ((box_.v1 + box_.v2) / 2 - v);
  const auto areaOf = [](const Frame& frame) { return length(cross(frame.du, frame.dv)); };
  const bool isDegenerate = areaOf(frameAt(u, v)) < kDegenerated * areaOf(frameAt(innerU, innerV));
  return isDegenerate ? normalAt(innerU, innerV) : normalAt(u, v);
}

GeneralSurface::Radii GeneralSurface::radiiAt(double u, double v) const {
  const SurfaceJet s = values_.bendAt(u, v);
  const Point3 normal = cross(s.du, s.dv);
  const auto radiusAlong = [&](const Point3& first, const Point3& second) {
    const double bend = std::abs(dot(second, normal));
    return bend > 0 ? dot(first, first) * length(normal) / bend : kInfinite;
  };
  return {smallestRadius(s, normal, lengthU_, lengthV_), radiusAlong(s.du, s.duu),
          radiusAlong(s.dv, s.dvv)};
}

void GeneralSurface::refine(const Point3& position, double& u, double& v) const {
  double bestU = u, bestV = v, best = std::numeric_limits<double>::infinity();
  double atU = u, atV = v;
  for (int step = 0; step < kMaxSteps; ++step) {
    const Frame s = frameAt(atU, atV);
    const Point3 r = position - s.position;
    const double gap = length(r);
    if (gap < best) {
      best = gap;
      bestU = atU;
      bestV = atV;
    }
    const double e = dot(s.du, s.du), f = dot(s.du, s.dv), g = dot(s.dv, s.dv);
    const double det = e * g - f * f;
    if (!(det > kDegenerate * e * g)) break;
    const double a = dot(r, s.du), b = dot(r, s.dv);
    const double stepU = (g * a - f * b) / det, stepV = (e * b - f * a) / det;
    atU = u_.closed ? atU + stepU : u_.bring(atU + stepU);
    atV = v_.closed ? atV + stepV : v_.bring(atV + stepV);
    if (std::abs(stepU) <= 1e-14 * u_.width() && std::abs(stepV) <= 1e-14 * v_.width()) break;
  }
  u = bestU;
  v = bestV;
}

std::optional<SurfacePoint> GeneralSurface::hit(const SurfaceLine& line) const {
  if (const auto found = hit(line, Steps::Full)) return found;
  return hit(line, Steps::Halved);
}

/// Newton's method. Full steps give up when they run away. Near singular parameters, only steps
/// that are halved until they come nearer find the surface.
std::optional<SurfacePoint> GeneralSurface::hit(const SurfaceLine& line, Steps steps) const {
  constexpr double kRunsAway = 4;
  double u = u_.bring((line.from.u + u_.near(line.to.u, line.from.u)) / 2);
  double v = v_.bring((line.from.v + v_.near(line.to.v, line.from.v)) / 2);
  const double tolerance = kPlaceTolerance * line.edgeLength;
  double last = std::numeric_limits<double>::infinity();
  double fromU = u, fromV = v, stepU = 0, stepV = 0;  // the last step
  for (int step = 0; step < kMaxSteps; ++step) {
    const Frame s = frameAt(u, v);
    const Point3 r = line.start - s.position;
    const double rx = dot(r, line.xAxis), ry = dot(r, line.yAxis);
    const double gap = std::abs(rx) + std::abs(ry);
    if (gap <= tolerance) {
      const auto normal = unitNormal(s);
      return SurfacePoint{s.position, normal ? *normal : normalAt(u, v), u, v};
    }
    if (steps == Steps::Full && gap > kRunsAway * last) return std::nullopt;
    if (steps == Steps::Halved && gap > last) {
      stepU /= 2;
      stepV /= 2;
    } else {
      last = gap;
      const double a = dot(s.du, line.xAxis), b = dot(s.dv, line.xAxis);
      const double c = dot(s.du, line.yAxis), d = dot(s.dv, line.yAxis);
      const double det = a * d - b * c;
      if (!(std::abs(det) >
            kDegenerate * (std::abs(a) + std::abs(c)) * (std::abs(b) + std::abs(d))))
        return std::nullopt;
      fromU = u;
      fromV = v;
      stepU = (d * rx - b * ry) / det;
      stepV = (a * ry - c * rx) / det;
    }
    u = u_.bring(fromU + stepU);
    v = v_.bring(fromV + stepV);
  }
  return std::nullopt;
}

}  // namespace af2::geometry
