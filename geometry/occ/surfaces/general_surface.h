// Surfaces by their parameters: those without a closed form (splines, revolutions, extrusions,
// offsets, ...), and the others where parameters are asked for. Not installed: includers need
// OpenCASCADE's headers.
#pragma once

#include <Geom_Surface.hxx>
#include <optional>

#include "geometry/charts/mean_normal_chart.h"
#include "geometry/charts/metric_chart.h"
#include "geometry/occ/surfaces/surface_values.h"

namespace af2::geometry {

/// One parameter of a surface: its range, and whether the surface is closed in it.
struct ParameterRange {
  double low = 0, high = 1;
  bool closed = false;

  double width() const { return high - low; }
  bool has(double value) const {
    constexpr double kSlack = 1e-6;  // of the width, because boundaries are not exact
    return closed || (value >= low - kSlack * width() && value <= high + kSlack * width());
  }
  /// `value` moved into the range: by whole periods if closed, else to the nearer end.
  double bring(double value) const;
  /// The value nearest to `other` that differs from `value` by whole periods, if closed.
  double near(double value, double other) const;
};

/// A surface in terms of its parameters. Must not be used from two threads at once.
class GeneralSurface final : public ParametricSurface {
 public:
  /// flipped  the face's normals are opposite to du x dv
  /// box      where the surface is needed; evaluation elsewhere may be slower
  GeneralSurface(const Handle(Geom_Surface) & surface, bool flipped, const SplineSurface::Box& box);

  /// Newton's method on the two parameters, started at the middle of the base edge.
  std::optional<SurfacePoint> hit(const SurfaceLine& line) const;

  Frame frameAt(double u, double v) const override { return values_.frameAt(u, v); }
  SurfaceJet jetAt(double u, double v) const override { return values_.jetAt(u, v); }
  SurfacePoint pointAt(double u, double v) const override;
  bool isFlipped() const override { return sign_ < 0; }
  bool has(double u, double v) const override { return u_.has(u) && v_.has(v); }
  /// The unit normal; where du x dv vanishes (a pole), the mean of the surrounding normals.
  Point3 normalAt(double u, double v) const;
  /// The normal at a point of the boundary. Where the parameters are almost degenerate, the normals
  /// may be noise, or show a twist too small to matter: then the normal slightly inside the face is
  /// used.
  Point3 normalAtBoundary(double u, double v) const;
  /// Radii of normal curvature: the smallest, and those along the two parameter lines; infinite
  /// where there is no curvature.
  struct Radii {
    double smallest, u, v;
  };
  Radii radiiAt(double u, double v) const;
  /// Moves (u, v) to the foot of the perpendicular from `position`, if that is near.
  void refine(const Point3& position, double& u, double& v) const;

  /// Makes the surface end at the ends of the box, also where it would continue or close.
  void endAtBox();

 private:
  enum class Steps { Full, Halved };
  std::optional<SurfacePoint> hit(const SurfaceLine& line, Steps steps) const;
  std::optional<Point3> unitNormal(const Frame& frame) const;
  /// Treats the surface as open where it meets itself at an angle.
  void openSharpEnds(const Handle(Geom_Surface) & surface);

  SurfaceValues values_;
  SplineSurface::Box box_;
  ParameterRange u_, v_;
  double sign_;
  double lengthU_ = 0, lengthV_ = 0;  ///< of du and dv, away from poles
};

}  // namespace af2::geometry
