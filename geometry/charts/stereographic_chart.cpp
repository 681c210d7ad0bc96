#include "geometry/charts/stereographic_chart.h"

#include "engine/base/error.h"

namespace af2::geometry {

namespace {
/// Below this share of the radius the middle of the base edge is too near the centre to define a
/// direction.
constexpr double kMinOffset = 1e-3;
}  // namespace

StereographicChart::StereographicChart(const SphereSurface& sphere, const SurfacePoint& from,
                                       const SurfacePoint& to, double edgeLength)
    : sphereCentre_(sphere.centre()),
      radius_(sphere.radius()),
      side_(sphere.side() == Side::Outer ? 1 : -1),
      edgeLength_(edgeLength) {
  const Point3 chord = to.position - from.position;
  const double size = length(chord);
  const Point3 along = (1 / size) * chord;
  const Point3 middle = from.position - sphereCentre_;
  const Point3 offset = middle - dot(middle, along) * along;
  const double distance = length(offset);
  if (!(distance > kMinOffset * radius_))
    throw GeometryError(
        "the ends of an edge are opposite points of a sphere; ask for a smaller size");
  up_ = (1 / distance) * offset;
  height_ = radius_ + distance;
  middle_ = size / 2;

  frame_.origin = from.position;
  frame_.xAxis = along;
  frame_.normal = side_ * up_;
  frame_.yAxis = cross(frame_.normal, along);
  frame_.scale = 1 / edgeLength;
  frame_.perspective = side_ / height_;
  frame_.centreX = middle_ * frame_.scale;
  frame_.maxHeight = std::abs(radius_ - distance);
}

std::optional<SurfacePoint> StereographicChart::transformToSurface(Point2 point) const {
  // From the opposite point through that of the plane to the sphere.
  const double x = edgeLength_ * point.x - middle_, y = edgeLength_ * point.y;
  const double share = 2 * height_ / (x * x + y * y + height_ * height_);
  const Point3 rough =
      (share * x) * frame_.xAxis + (share * y) * frame_.yAxis + (share * height_ - 1) * up_;
  // Its length is 1 but for rounding; one step of Newton's method for that.
  const Point3 radial = (1.5 - 0.5 * dot(rough, rough)) * rough;
  return SurfacePoint{sphereCentre_ + radius_ * radial, side_ * radial};
}

}  // namespace af2::geometry
