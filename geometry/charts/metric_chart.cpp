#include "geometry/charts/metric_chart.h"

#include <algorithm>

#include "engine/base/error.h"

namespace af2::geometry {

namespace {
/// The area of du x dv counts as zero below this share of |du| |dv|.
constexpr double kDegenerate = 1e-9;
/// Half the turn of an edge, in radians, within the surface against the lines of the parameters:
/// with more, charts would fold within the reach of the rules, four edges or so.
constexpr double kMaxTurn = 0.12;
/// The bend of a chart at a place, over the distance of the place.
constexpr double kMaxBend = 0.5;
/// New vertices lie on the surface wherever these stop.
constexpr int kInverseSteps = 12;
constexpr double kPlaceTolerance = 1e-4;  // in the chart
}  // namespace

MetricChart::MetricChart(const ParametricSurface& surface, const SurfacePoint& from,
                         const SurfacePoint& to, double edgeLength, MetricOrder order)
    : surface_(surface), u_(from.u), v_(from.v) {
  const double du = to.u - from.u, dv = to.v - from.v;
  const SurfaceJet frame = surface.jetAt(from.u + du / 2, from.v + dv / 2);
  const double e = dot(frame.du, frame.du), f = dot(frame.du, frame.dv);
  const double g = dot(frame.dv, frame.dv);
  const double det = e * g - f * f;
  const double along = std::sqrt(e * du * du + 2 * f * du * dv + g * dv * dv);
  if (!(det > kDegenerate * e * g) || !(along > 0))
    throw GeometryError("the parameters of the surface are degenerate here");

  // Unit vectors along and across the base edge, in parameters and for the metric.
  const double area = (surface.isFlipped() ? -1 : 1) * std::sqrt(det);
  const double alongU = du / along, alongV = dv / along;
  const double acrossU = -(f * alongU + g * alongV) / area;
  const double acrossV = (e * alongU + f * alongV) / area;

  // The chord is a little shorter than the metric says; x is stretched so that `to` lies at it.
  const double length = distance(from.position, to.position);
  if (!(length > 0)) throw GeometryError("an edge has no length here");
  const double perLengthX = along / length * edgeLength, perLengthY = edgeLength;
  ux_ = perLengthX * alongU;
  vx_ = perLengthX * alongV;
  uy_ = perLengthY * acrossU;
  vy_ = perLengthY * acrossV;
  const double inverse = 1 / (ux_ * vy_ - uy_ * vx_);
  xu_ = inverse * vy_;
  xv_ = -inverse * uy_;
  yu_ = -inverse * vx_;
  yv_ = inverse * ux_;

  end_ = length / edgeLength;
  isAffine_ = true;
  if (order == MetricOrder::First) return;

  // How steps of the chart turn within the surface.
  const auto turnOf = [&](const Point3& second) {
    const double a = 0.5 * dot(second, frame.du), b = 0.5 * dot(second, frame.dv);
    const double u = (g * a - f * b) / det, v = (e * b - f * a) / det;
    return Point2{xu_ * u + xv_ * v, yu_ * u + yv_ * v};
  };
  const Point2 uu = turnOf(frame.duu), uv = turnOf(frame.duv), vv = turnOf(frame.dvv);
  xx_ = (ux_ * ux_) * uu + (2 * ux_ * vx_) * uv + (vx_ * vx_) * vv;
  xy_ = (ux_ * uy_) * uu + (ux_ * vy_ + uy_ * vx_) * uv + (vx_ * vy_) * vv;
  yy_ = (uy_ * uy_) * uu + (2 * uy_ * vy_) * uv + (vy_ * vy_) * vv;
  // Where an edge turns by too much, as beside a pole, the second order does not hold as far as the
  // next edges: rather none of it.
  const double turn = std::sqrt(std::max({dot(xx_, xx_), dot(xy_, xy_), dot(yy_, yy_)}));
  if (turn > kMaxTurn) {
    const double less = (kMaxTurn / turn) * (kMaxTurn / turn);
    xx_ = less * xx_;
    xy_ = less * xy_;
    yy_ = less * yy_;
  }
  isAffine_ = xx_ == Point2{} && xy_ == Point2{} && yy_ == Point2{};
}

Point2 MetricChart::bent(Point2 p) const {
  // Coordinates about the middle of the base edge are bent, but those of its ends stay.
  const double x = p.x - end_;
  const Point2 bend = (p.x * x) * xx_ + (p.y * (p.x + x)) * xy_ + (p.y * p.y) * yy_;
  // Farther off the second order is no better than the first, and would fold over.
  const double most = kMaxBend * kMaxBend * dot(p, p), size = dot(bend, bend);
  return p + (size > most ? std::sqrt(most / size) : 1) * bend;
}

ChartPoint MetricChart::transformFromSurface(const SurfacePoint& point) const {
  const double du = point.u - u_, dv = point.v - v_;
  const Point2 p{xu_ * du + xv_ * dv, yu_ * du + yv_ * dv};
  return {isAffine_ ? p : bent(p), ChartView::Legal};
}

std::optional<SurfacePoint> MetricChart::transformToSurface(Point2 point) const {
  Point2 p = point;
  for (int step = 0; !isAffine_ && step < kInverseSteps; ++step) {
    const Point2 rest = point - bent(p);
    p = p + rest;
    if (dot(rest, rest) < kPlaceTolerance * kPlaceTolerance) break;
  }
  const double u = u_ + ux_ * p.x + uy_ * p.y, v = v_ + vx_ * p.x + vy_ * p.y;
  if (!surface_.has(u, v)) return std::nullopt;
  return surface_.pointAt(u, v);
}

}  // namespace af2::geometry
