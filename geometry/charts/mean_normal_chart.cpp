#include "geometry/charts/mean_normal_chart.h"

#include "engine/base/error.h"

namespace af2::geometry {

namespace {
/// Below this length the part of the mean normal across the base edge is noise. The mean of two
/// normals 179 degrees apart is longer.
constexpr double kMinNormal = 1e-2;
}  // namespace

ProjectionFrame meanNormalFrame(const SurfacePoint& from, const SurfacePoint& to, double edgeLength,
                                const ChartLimits& limits) {
  const Point3 along = unit(to.position - from.position);
  const Point3 sum = from.normal + to.normal;
  const Point3 across = sum - dot(sum, along) * along;
  if (!(length(across) > kMinNormal))
    throw GeometryError(
        "the normals at the ends of an edge cancel: the edge turns by 180 degrees; "
        "ask for a smaller size here");

  ProjectionFrame frame;
  frame.origin = from.position;
  frame.xAxis = along;
  frame.normal = unit(across);
  frame.yAxis = cross(frame.normal, along);
  frame.scale = 1 / edgeLength;
  frame.minCosine = limits.minCosine;
  frame.hiddenCosine = limits.hiddenCosine;
  frame.maxHeight = limits.maxHeight * edgeLength;
  return frame;
}

}  // namespace af2::geometry
