#include "geometry/charts/conformal_chart.h"

#include "geometry/charts/laid_out.h"

namespace af2::geometry {

namespace {
/// Where lengths vary more than this from one edge to the next, they cannot be trusted farther off.
constexpr double kMaxStretchChange = 0.25;
}  // namespace

ConformalChart::ConformalChart(const PlaneMap& map, const SurfacePoint& from,
                               const SurfacePoint& to, double edgeLength)
    : edgeLength_(edgeLength) {
  const Point3 chord = to.position - from.position;
  const double size = length(chord);
  frame_.origin = from.position;
  frame_.xAxis = (1 / size) * chord;
  frame_.yAxis = {-frame_.xAxis.y, frame_.xAxis.x, 0};
  frame_.normal = {0, 0, 1};
  frame_.scale = 1 / edgeLength;

  // Lengths on the surface go with 1 / scale.
  const Point2 middle = 0.5 * (placeOf(from) + placeOf(to));
  const Point2 gradient = (-edgeLength) * map.scaleGradientAt(middle);
  const Point2 x{frame_.xAxis.x, frame_.xAxis.y}, y{frame_.yAxis.x, frame_.yAxis.y};
  frame_.bend = {0.5 * dot(gradient, x), -0.5 * dot(gradient, y)};
  const double most = length(frame_.bend);
  if (!(most <= kMaxStretchChange))
    frame_.bend = most > 0 ? (kMaxStretchChange / most) * frame_.bend : Point2{};
  const double end = size / edgeLength;
  frame_.kept = {1 - end * frame_.bend.x, -end * frame_.bend.y};
}

std::optional<SurfacePoint> ConformalChart::transformToSurface(Point2 point) const {
  const Point2 p = edgeLength_ * frame_.straightened(point);
  const Point3 position = frame_.origin + p.x * frame_.xAxis + p.y * frame_.yAxis;
  return pointInPlane({position.x, position.y});
}

}  // namespace af2::geometry
