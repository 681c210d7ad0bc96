// The surface under one face: closed forms where there are, OpenCASCADE elsewhere.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Face.hxx>
#include <cmath>
#include <limits>
#include <memory>
#include <variant>
#include <vector>

#include "engine/surface/local_transform.h"
#include "geometry/charts/chart_kind.h"
#include "geometry/charts/charted_surface.h"
#include "geometry/charts/mean_normal_chart.h"
#include "geometry/charts/plane_map.h"
#include "geometry/charts/quadric_surfaces.h"
#include "geometry/charts/spline_extrusion.h"
#include "geometry/charts/unrolled_surfaces.h"
#include "geometry/occ/surfaces/creases.h"
#include "geometry/occ/surfaces/general_surface.h"
#include "geometry/occ/surfaces/sharp_tips.h"
#include "geometry/occ/surfaces/surface_bend.h"

namespace af2::geometry {

struct PlaneSurface {
  Point3 origin, normal;

  /// A point that a careless file has put beside the plane goes down to it: a front in the plane
  /// does not look above it. What is near enough stays as it is.
  Point3 drawnOnto(const Point3& p) const {
    constexpr double kNear = 1e-4;  // of the distance from the origin, a point of the face
    const double height = dot(p - origin, normal);
    return std::abs(height) <= kNear * distance(p, origin) ? p : p - height * normal;
  }
};

/// Knows normals, curvature and charts of a face. Not to be shared between threads, but each may
/// have a copy.
class FaceSurface final : public ChartedSurface {
 public:
  /// Throws GeometryError if the face has no surface.
  explicit FaceSurface(const TopoDS_Face& face);
  /// Of a face with creases: normals at the boundary and radii are those beside them.
  FaceSurface(const TopoDS_Face& face, FaceCells cells);
  /// One of the cells of such a face, which ends at its creases.
  static FaceSurface ofCell(const TopoDS_Face& face, const Stretch& u, const Stretch& v);

  /// A point of the boundary from its place in OpenCASCADE's parameters. The position is given: it
  /// may lie beside the surface by as much as the tolerances of the model allow.
  SurfacePoint boundaryPoint(const Point3& position, double u, double v) const;
  /// A point at its place in our parameters, which is improved where it is needed later.
  SurfacePoint pointAt(const Point3& position, double u, double v) const;
  /// How the surface bends at a point.
  struct Radii {
    /// Smaller radius of curvature. Near a sharp tip, as of a cone, that at a distance of `reach`
    /// from it: smaller elements would see the same sharp tip.
    double smallest;
    /// Smaller radius of curvature along those parameter lines on which the face turns by more than
    /// about a right angle: a tube, but not the rounding of an edge. Infinite if there are none.
    double bent;
  };
  Radii radiiAt(const SurfacePoint& point, double reach = 0) const;
  bool isPlane() const override { return std::holds_alternative<PlaneSurface>(surface_); }
  /// Whether there is no closed form: its parameters are all that is known.
  bool isGeneral() const { return std::holds_alternative<GeneralSurface>(surface_); }
  std::vector<SharpTip> sharpTips() const;
  /// A place on the way around a sharp tip between two places near it: `share` of the angle.
  SurfacePoint aroundTip(const SurfacePoint& from, const SurfacePoint& to, double share) const;
  /// The angle along the surface between two places near the sharp tip at `tip`.
  double angleAroundTip(const SurfacePoint& from, const SurfacePoint& to, const Point3& tip) const;
  /// Whether radiiAt is the same everywhere.
  bool isBentAlike() const {
    return isPlane() || std::holds_alternative<CylinderSurface>(surface_) ||
           std::holds_alternative<SphereSurface>(surface_);
  }
  /// Distance of the parts of the face that are farthest from each other, roughly.
  double extent() const { return extent_; }
  /// Of the shortest parameter line on which the face turns by more than about a right angle;
  /// infinite if there is none.
  double breadth() const { return breadth_; }
  /// The least radius at which the face turns all along a crease across such lines. Infinite if
  /// there are none.
  double creaseRadius() const { return creaseRadius_; }
  /// The part of OpenCASCADE's parameters that the face takes up; of a plane, any part.
  const SplineSurface::Box& box() const { return box_; }

  /// Makes the published charts; for a plane, the exact one.
  std::unique_ptr<AF2LocalTransformMaker> makeCharts(const ChartLimits& limits) const;

  bool has(ChartKind kind) const override;
  std::unique_ptr<AF2LocalTransformMaker> makeCharts(ChartKind kind) const override;
  std::unique_ptr<PlaneMap> makePlaneMap(ChartKind kind) const override;
  /// The surface by our parameters (u, v): OpenCASCADE's, but for a cylinder and a cone those of
  /// the unrolled surface. There always are some.
  const ParametricSurface* inParameters() const override;
  SurfacePoint at(double u, double v) const override;
  const GeneralSurface& inOccParameters() const { return parametric_; }

 private:
  /// flipped  the normals of the face are opposite to du x dv
  FaceSurface(const Handle(Geom_Surface) & surface, const SplineSurface::Box& box, bool flipped,
              FaceCells cells = {});
  void measure();
  SurfaceBend bendBetweenCreases() const;
  std::unique_ptr<AF2LocalTransformMaker> normalLineCharts() const;
  bool isBent() const { return isBentInU_ || isBentInV_; }

  using Surface = std::variant<PlaneSurface, CylinderSurface, ConeSurface, SphereSurface,
                               TorusSurface, GeneralSurface>;

  SplineSurface::Box box_;
  FaceCells cells_;  ///< none: no creases
  GeneralSurface parametric_;
  Surface surface_;
  std::shared_ptr<const UnrolledSurface> unrolled_;  ///< null: there is none
  bool isBentInU_ = false, isBentInV_ = false, hasTip_ = false;
  SharpTips tips_;  ///< of a GeneralSurface
  double extent_ = 0;
  double breadth_ = std::numeric_limits<double>::infinity();
  double creaseRadius_ = std::numeric_limits<double>::infinity();
  enum class Sweep { None, Torus, Revolution } sweep_ = Sweep::None;
  AxisFrame sweepAxis_;                 ///< of a surface of revolution without x and y
  std::optional<Extrusion> extrusion_;  ///< also of splines that are one
};

}  // namespace af2::geometry
