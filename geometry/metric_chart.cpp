#include "geometry/metric_chart.h"

#include "engine/error.h"

namespace af2::geometry {

namespace {
/// The area of du x dv counts as zero below this share of |du| |dv|.
constexpr double kDegenerate = 1e-9;
}  // namespace

MetricChart::MetricChart(const ParametricSurface& surface, const SurfacePoint& from,
                         const SurfacePoint& to, double edgeLength)
    : surface_(surface), u_(from.u), v_(from.v) {
  const double du = to.u - from.u, dv = to.v - from.v;
  const auto frame = surface.frameAt(from.u + du / 2, from.v + dv / 2);
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
}

}  // namespace af2::geometry
