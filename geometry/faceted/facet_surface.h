// One smooth patch of triangles as a surface: normals, curvature, and the way back from a chart.
#pragma once

#include <memory>
#include <optional>

#include "geometry/box_tree.h"
#include "geometry/faceted/patches.h"
#include "geometry/mean_normal_chart.h"

namespace af2::geometry {

/// Positions lie on the triangles. Normals are smooth: at each vertex the mean over the triangles
/// of the patch around it, weighted by their angles there, and linear in between. Immutable; copies
/// share the same data.
class FacetSurface {
 public:
  FacetSurface(const Facets& facets, const Patch& patch);

  /// Where a line meets the patch nearest to its start; if it misses, e.g. beside a boundary of
  /// chords, the nearest point of the patch, if that is near.
  std::optional<SurfacePoint> hit(const SurfaceLine& line) const;
  /// The nearest point of the patch.
  SurfacePoint nearest(const Point3& position) const;
  /// How fast the normals turn at the nearest point, as a radius; infinite where they do not.
  double radiusAt(const Point3& position) const;
  double area() const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace af2::geometry
