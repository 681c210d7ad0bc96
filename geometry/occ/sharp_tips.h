// Where a surface by its parameters ends in a tip as sharp as that of a cone.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <optional>
#include <vector>

#include "geometry/occ/general_surface.h"

namespace af2::geometry {

/// Places where a side of the parameters is one point, with normals that do not come together
/// there: radii of curvature go to zero on the way, but smaller elements see the same sharp tip.
class SharpTips {
 public:
  SharpTips() = default;
  /// box  the part of the parameters that the face takes up
  SharpTips(const GeneralSurface& surface, const SplineSurface::Box& box);

  /// By how much radii of curvature count as larger than they are at `position`, so that nearer
  /// to a tip than `reach` they are about those at this distance. At least 1; infinite at the tip.
  double easing(const Point3& position, double reach) const;

  /// The mean of the normals around the tip at `position`; nothing if there is none.
  std::optional<Point3> normalAt(const Point3& position) const;

 private:
  struct Tip {
    Point3 position, normal;
    double slack;  ///< nearer than this is at the tip
  };
  std::vector<Tip> tips_;
};

}  // namespace af2::geometry
