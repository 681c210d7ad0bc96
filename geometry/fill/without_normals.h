// A surface without normals, for faces that are rough on the scale of their elements.
// Not installed.
#pragma once

#include "engine/mesh/front_input.h"
#include "engine/mesh/mesh.h"
#include "geometry/charts/metric_chart.h"

namespace af2::geometry {

/// The surface of a face without its normals, so that elements may tilt against it by any angle.
class WithoutNormals final : public ParametricSurface {
 public:
  explicit WithoutNormals(const ParametricSurface& surface) : surface_(surface) {}
  Frame frameAt(double u, double v) const override { return surface_.frameAt(u, v); }
  SurfacePoint pointAt(double u, double v) const override {
    SurfacePoint point = surface_.pointAt(u, v);
    point.normal = {};
    return point;
  }
  bool isFlipped() const override { return surface_.isFlipped(); }
  bool has(double u, double v) const override { return surface_.has(u, v); }

 private:
  const ParametricSurface& surface_;
};

FrontInput withoutNormals(FrontInput input);

/// Sets the normals of the vertices of a mesh to those of the surface at their parameters.
void restoreNormals(const ParametricSurface& surface, const FrontInput& input, Mesh& mesh);

/// Whether all elements have the right orientation in the parameters: then none is folded.
bool isFlatInParameters(const Mesh& mesh, bool isFlipped);

}  // namespace af2::geometry
