#include "engine/surface/plane_chart.h"

namespace af2 {

PlaneChart::PlaneChart(const SurfacePoint& from, const SurfacePoint& to, const Point3& normal,
                       double edgeLength)
    : edgeLength_(edgeLength) {
  const Point3 along = to.position - from.position;
  frame_.origin = from.position;
  // Within rounding the result is in the plane, even if the given points lie slightly beside it.
  frame_.xAxis = unit(along - dot(along, normal) * normal);
  frame_.yAxis = cross(normal, frame_.xAxis);
  frame_.normal = normal;
  frame_.scale = 1 / edgeLength;
}

}  // namespace af2
