// The surface under one face: closed forms where there are, OpenCASCADE elsewhere.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Face.hxx>
#include <memory>
#include <variant>

#include "engine/local_transform.h"
#include "geometry/mean_normal_chart.h"
#include "geometry/occ/general_surface.h"
#include "geometry/quadric_surfaces.h"

namespace af2::geometry {

struct PlaneSurface {
  Point3 normal;
};

/// Knows normals, curvature and charts of a face. Not to be shared between threads.
class FaceSurface {
 public:
  /// Throws GeometryError if the face has no surface.
  explicit FaceSurface(const TopoDS_Face& face);

  /// A point of the boundary, whose position is given: it may lie beside the surface by as much as
  /// the tolerances of the model allow. (u, v) is improved where it is needed later.
  SurfacePoint pointAt(const Point3& position, double u, double v) const;
  double curvatureRadiusAt(const SurfacePoint& point) const;
  bool isPlane() const { return std::holds_alternative<PlaneSurface>(surface_); }
  /// Whether normals of the face differ by more than about a right angle.
  bool isBent() const { return isBent_; }

  /// Makes the published charts; for a plane, the exact one.
  std::unique_ptr<AF2LocalTransformMaker> makeCharts(const ChartLimits& limits) const;

  bool flipped() const { return flipped_; }
  const GeneralSurface& inParameters() const { return parametric_; }

 private:
  using Surface = std::variant<PlaneSurface, CylinderSurface, ConeSurface, SphereSurface,
                               TorusSurface, GeneralSurface>;

  bool flipped_, isBent_ = false;
  GeneralSurface parametric_;
  Surface surface_;
};

}  // namespace af2::geometry
