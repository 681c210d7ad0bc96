// Finds tips of parametric surfaces that are as sharp as that of a cone.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <optional>
#include <vector>

#include "geometry/occ/surfaces/general_surface.h"

namespace af2::geometry {

struct SharpTip {
  Point3 position;
  double slack = 0;  ///< points nearer than this are at the tip
  /// The angle around the tip along the surface: a plane sector with this angle, rolled up to a
  /// whole turn, is the surface there. It is 2 pi sin(a) for a cone with an angle of a between axis
  /// and surface.
  double angle = 0;
};

/// Places where a side of the parameter range is one point, at which the normals do not converge:
/// radii of curvature go to zero towards the tip, but smaller elements would meet the same sharp
/// tip.
class SharpTips {
 public:
  SharpTips() = default;
  /// box  the part of the parameters that the face occupies
  SharpTips(const GeneralSurface& surface, const SplineSurface::Box& box);

  /// The factor, at least 1, by which radii of curvature at `position` are enlarged, so that nearer
  /// to a tip than `reach` they are about those at this distance.
  double easing(const Point3& position, double reach) const;
  /// At a tip itself, where no radius of curvature can be computed, the radius at a distance of
  /// `reach`.
  std::optional<double> radiusAtTip(const Point3& position, double reach) const;

  /// The mean of the normals around the tip at `position`; nothing if there is none.
  std::optional<Point3> normalAt(const Point3& position) const;

  std::vector<SharpTip> all() const { return {tips_.begin(), tips_.end()}; }

  /// The angle along the surface between two places near the tip at `position`; 0: there is none.
  double angleBetween(const SurfacePoint& from, const SurfacePoint& to,
                      const Point3& position) const;

 private:
  struct Tip : SharpTip {
    Point3 normal;
    bool isAlongU;     ///< the side of the parameters that is the tip
    double perLength;  ///< angle along the surface, per length of that side
  };
  /// A tip that is nearer than `times` its slack, or null.
  const Tip* tipAt(const Point3& position, double times = 1) const;

  std::vector<Tip> tips_;
};

}  // namespace af2::geometry
