// The surface of one face: in closed form where there is one, else from OpenCASCADE.
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

  /// Projects a point that an inexact file has put off the plane onto it, because a front in the
  /// plane ignores the distance from it. Points that are near enough are not changed.
  Point3 drawnOnto(const Point3& p) const {
    constexpr double kNear = 1e-6;  // of the distance from the origin, a point of the face
    const double height = dot(p - origin, normal);
    return std::abs(height) <= kNear * distance(p, origin) ? p : p - height * normal;
  }
};

/// Provides normals, curvature and charts of a face. Must not be shared between threads, but each
/// may have a copy.
class FaceSurface final : public ChartedSurface {
 public:
  /// Throws GeometryError if the face has no surface.
  explicit FaceSurface(const TopoDS_Face& face);
  /// For a face with creases: normals at the boundary, and radii, are those next to the creases.
  FaceSurface(const TopoDS_Face& face, FaceCells cells);
  /// The surface of one cell of such a face, which ends at the creases.
  static FaceSurface ofCell(const TopoDS_Face& face, const Stretch& u, const Stretch& v);

  /// A point of the boundary from its place in OpenCASCADE's parameters. The position is given,
  /// because it may be off the surface by as much as the tolerances of the model allow.
  SurfacePoint boundaryPoint(const Point3& position, double u, double v) const;
  /// A point at its place in AF2's parameters, which is improved later where needed.
  SurfacePoint pointAt(const Point3& position, double u, double v) const;
  /// The radii of curvature of the surface at a point.
  struct Radii {
    /// Smaller radius of curvature. Near a sharp tip, such as that of a cone, the radius at a
    /// distance of `reach` from the tip: smaller elements would meet the same sharp tip.
    double smallest;
    /// Smaller radius of curvature along those parameter lines on which the face turns by more than
    /// about a right angle: a tube, but not the rounding of an edge. Infinite if there are none.
    double bent;
  };
  Radii radiiAt(const SurfacePoint& point, double reach = 0) const;
  bool isPlane() const override { return std::holds_alternative<PlaneSurface>(surface_); }
  /// Whether there is no closed form, so that only the parametrisation is available.
  bool isGeneral() const { return std::holds_alternative<GeneralSurface>(surface_); }
  /// Whether a tube is as far around everywhere as its radius there says: that is known of the
  /// closed forms and of what is revolved around an axis.
  bool isRound() const {
    return !isGeneral() || (sweep_ == Sweep::Revolution && isBentInU_ && !isBentInV_);
  }
  std::vector<SharpTip> sharpTips() const;
  /// A place around a sharp tip between two places near it, at the fraction `share` of the angle.
  SurfacePoint aroundTip(const SurfacePoint& from, const SurfacePoint& to, double share) const;
  /// The angle along the surface between two places near the sharp tip at `tip`.
  double angleAroundTip(const SurfacePoint& from, const SurfacePoint& to, const Point3& tip) const;
  /// Whether radiiAt is the same everywhere.
  bool isBentAlike() const {
    return isPlane() || std::holds_alternative<CylinderSurface>(surface_) ||
           std::holds_alternative<SphereSurface>(surface_);
  }
  /// Approximate diameter of the face.
  double extent() const { return extent_; }
  /// Length of the shortest parameter line on which the face turns by more than about a right
  /// angle; infinite if there is none.
  double breadth() const { return breadth_; }
  /// How far it is around the face if it is a tube; far more than its least radius says if it is
  /// none, as at the leading edge of a wing. Infinite if the face is not bent by so much.
  double girth() const { return girth_; }
  /// The least radius at which the face turns along a whole crease across such lines. Infinite if
  /// there are none.
  double creaseRadius() const { return creaseRadius_; }
  /// Whether the face turns back and forth along such a line.
  bool isWavy() const { return isWavy_; }
  /// The part of OpenCASCADE's parameters that the face occupies; arbitrary for a plane.
  const SplineSurface::Box& box() const { return box_; }

  /// Makes the published charts; for a plane, the exact one.
  std::unique_ptr<AF2LocalTransformMaker> makeCharts(const ChartLimits& limits) const;

  bool has(ChartKind kind) const override;
  std::unique_ptr<AF2LocalTransformMaker> makeCharts(ChartKind kind) const override;
  std::unique_ptr<PlaneMap> makePlaneMap(ChartKind kind) const override;
  /// The surface by AF2's parameters (u, v): those of OpenCASCADE, except on a cylinder and a cone,
  /// where they are those of the unrolled surface. Never null.
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
  double girth_ = std::numeric_limits<double>::infinity();
  double creaseRadius_ = std::numeric_limits<double>::infinity();
  bool isWavy_ = false;
  enum class Sweep { None, Torus, Revolution } sweep_ = Sweep::None;
  AxisFrame sweepAxis_;                 ///< of a surface of revolution without x and y
  std::optional<Extrusion> extrusion_;  ///< also for splines that are extrusions
};

}  // namespace af2::geometry
