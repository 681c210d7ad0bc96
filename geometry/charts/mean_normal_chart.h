// The published chart: a plane normal to the mean of the normals at the two ends of the base edge.
// Orthogonal projection to the plane, and back along the normal of the plane. Source:
// [VanderZee16].
#pragma once

#include "engine/base/export.h"
#include "engine/surface/local_transform.h"

namespace af2::geometry {

/// How far around the base edge a chart is trusted.
struct ChartLimits {
  /// Least cosine of the angle between the normals of the surface and of the chart, at a vertex
  /// that rules may match and at a new vertex. At 0.25, about 75 degrees, lengths are foreshortened
  /// to a quarter.
  double minCosine = 0.25;
  /// Vertices whose normal has a smaller cosine face away: they are on another sheet of the
  /// surface.
  double hiddenCosine = 0;
  /// Largest distance from the plane, in wanted edge lengths. A surface that curves as much as the
  /// least cosine allows stays within it; another sheet of the face with the same normal mostly
  /// does not.
  double maxHeight = 2.5;
};

/// A line perpendicular to a chart, along which a point goes back to the surface, and the nearest
/// known points of the surface.
struct SurfaceLine {
  Point3 start;      ///< on the plane of the chart
  Point3 direction;  ///< unit normal of the chart
  Point3 xAxis, yAxis;
  const SurfacePoint& from;  ///< ends of the base edge: seeds
  const SurfacePoint& to;
  double edgeLength;  ///< wanted, in model units
};

/// The plane of a chart.
///
/// Throws GeometryError if the mean of the normals at `from` and `to` is along the base edge or
/// zero.
AF2_EXPORT ProjectionFrame meanNormalFrame(const SurfacePoint& from, const SurfacePoint& to,
                                           double edgeLength, const ChartLimits& limits);

/// The line perpendicular to such a plane at a point of the chart.
inline SurfaceLine lineAt(const ProjectionFrame& frame, Point2 point, const SurfacePoint& from,
                          const SurfacePoint& to, double edgeLength) {
  const Point3 start =
      frame.origin + (edgeLength * point.x) * frame.xAxis + (edgeLength * point.y) * frame.yAxis;
  return {start, frame.normal, frame.xAxis, frame.yAxis, from, to, edgeLength};
}

/// The published chart on a Surface: any class with
///   std::optional<SurfacePoint> hit(const SurfaceLine& line) const;
/// which gives the point where the line meets the surface near its start, with the face's normal.
template <class Surface>
class MeanNormalChart final : public AF2LocalTransform {
 public:
  MeanNormalChart(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to,
                  double edgeLength, const ChartLimits& limits)
      : surface_(surface),
        from_(from),
        to_(to),
        frame_(meanNormalFrame(from, to, edgeLength, limits)),
        edgeLength_(edgeLength) {}

  ChartPoint transformFromSurface(const SurfacePoint& point) const override {
    return frame_.project(point);
  }

  std::optional<SurfacePoint> transformToSurface(Point2 point) const override {
    auto hit = surface_.hit(lineAt(frame_, point, from_, to_, edgeLength_));
    if (!hit || !isTrusted(*hit)) return std::nullopt;
    return hit;
  }

  const ProjectionFrame* projection() const override { return &frame_; }

 private:
  bool isTrusted(const SurfacePoint& hit) const {
    const double height = dot(hit.position - frame_.origin, frame_.normal);
    return dot(hit.normal, frame_.normal) >= frame_.minCosine &&
           std::abs(height) <= frame_.maxHeight;
  }

  const Surface& surface_;
  SurfacePoint from_, to_;  // copies: the points of the front may be reallocated meanwhile
  ProjectionFrame frame_;
  double edgeLength_;
};

/// Makes charts of a kind on a Surface: Chart<Surface>, from the ends of the base edge, the length
/// of the unit and limits.
template <template <class> class Chart, class Surface>
class LimitedChartMaker final : public ChartMaker<LimitedChartMaker<Chart, Surface>> {
 public:
  explicit LimitedChartMaker(Surface surface, const ChartLimits& limits = {})
      : surface_(std::move(surface)), limits_(limits) {}

  Chart<Surface> chart(const SurfacePoint& from, const SurfacePoint& to, double edgeLength) const {
    return {surface_, from, to, edgeLength, limits_};
  }

 private:
  Surface surface_;
  ChartLimits limits_;
};

/// Makes the published chart.
template <class Surface>
using MeanNormalChartMaker = LimitedChartMaker<MeanNormalChart, Surface>;

}  // namespace af2::geometry
