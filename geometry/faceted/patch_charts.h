// The charts of a curved patch of triangles.
// Not installed.
#pragma once

#include "geometry/charts/charted_surface.h"
#include "geometry/faceted/facet_surface.h"

namespace af2::geometry {

/// The mean-normal charts; also charts in the layout of the patch in one plane, if it has one, else
/// along the normals.
class PatchCharts final : public ChartedSurface, public ParametricSurface {
 public:
  explicit PatchCharts(FacetSurface surface) : surface_(std::move(surface)) {}

  bool isPlane() const override { return false; }
  bool has(ChartKind kind) const override;
  std::unique_ptr<AF2LocalTransformMaker> makeCharts(ChartKind kind) const override;
  const ParametricSurface* inParameters() const override {
    return surface_.isDrawn() ? this : nullptr;
  }
  /// Throws GeometryError if the patch has no layout in a plane.
  SurfacePoint at(double u, double v) const override;
  Frame frameAt(double u, double v) const override { return surface_.frameAt(u, v); }
  SurfacePoint pointAt(double u, double v) const override { return surface_.pointAt(u, v); }
  bool isFlipped() const override { return false; }

 private:
  FacetSurface surface_;
};

}  // namespace af2::geometry
