// A chart in the parameters of a surface: geodesic coordinates about the middle of the base edge,
// to second order.
#pragma once

#include "engine/base/export.h"
#include "engine/surface/local_transform.h"
#include "geometry/charts/surface_frame.h"

namespace af2::geometry {

/// A surface by its parameters, as a metric chart needs it.
class AF2_EXPORT ParametricSurface {
 public:
  using Frame = SurfaceFrame;
  virtual ~ParametricSurface() = default;
  virtual Frame frameAt(double u, double v) const = 0;
  /// The second derivatives may lack their components along the normal. This default gives none,
  /// which is right for parameters that are lengths.
  virtual SurfaceJet jetAt(double u, double v) const {
    const Frame frame = frameAt(u, v);
    return {frame.position, frame.du, frame.dv, {}, {}, {}};
  }
  /// The point with its parameters (u, v), its position and the normal of the face.
  virtual SurfacePoint pointAt(double u, double v) const = 0;
  /// Whether the normals of the face are opposite to du x dv.
  virtual bool isFlipped() const = 0;
  /// Whether the surface is defined at (u, v); elsewhere formulas may diverge.
  virtual bool has(double, double) const { return true; }
};

enum class MetricOrder {
  First,  ///< affine in (u, v): what is straight in one chart is so in all, so that a front cannot
          ///< run over itself, whatever the surface
  Second  ///< quadratic, so that lines of the chart are geodesics and its lengths those on the
          ///< surface to second order
};

/// Places each corner of the front by its own parameters, so that the two sides of a seam are
/// apart.
class AF2_EXPORT MetricChart final : public AF2LocalTransform {
 public:
  /// Throws GeometryError where the parameters are degenerate.
  MetricChart(const ParametricSurface& surface, const SurfacePoint& from, const SurfacePoint& to,
              double edgeLength, MetricOrder order);

  ChartPoint transformFromSurface(const SurfacePoint& point) const override;
  std::optional<SurfacePoint> transformToSurface(Point2 point) const override;

 private:
  /// Converts a place in the affine chart about `from` to the final, bent chart.
  Point2 bent(Point2 p) const;

  const ParametricSurface& surface_;
  double u_, v_;              // of the start of the base edge
  double xu_, xv_, yu_, yv_;  // from parameters to the affine chart
  double ux_, uy_, vx_, vy_;  // and back
  Point2 xx_, xy_, yy_;       // half the Christoffel symbols at the middle, in that chart
  double end_;                // of the base edge, on the x axis
  bool isAffine_;
};

class MetricChartMaker final : public ChartMaker<MetricChartMaker> {
 public:
  /// surface  is kept as a reference
  explicit MetricChartMaker(const ParametricSurface& surface,
                            MetricOrder order = MetricOrder::Second)
      : surface_(surface), order_(order) {}

  MetricChart chart(const SurfacePoint& from, const SurfacePoint& to, double edgeLength) const {
    return {surface_, from, to, edgeLength, order_};
  }

 private:
  const ParametricSurface& surface_;
  MetricOrder order_;
};

}  // namespace af2::geometry
