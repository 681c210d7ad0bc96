// One smooth patch of triangles as a surface: normals, curvature, and the way back from a chart.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/base/box_tree.h"
#include "geometry/charts/flat_surface.h"
#include "geometry/charts/mean_normal_chart.h"
#include "geometry/charts/surface_frame.h"
#include "geometry/faceted/patches.h"

namespace af2::geometry {

/// Positions lie on the triangles. Normals are smooth: at each vertex the mean over the triangles
/// of the patch around it, weighted by their angles there, and linear in between; in small
/// roundings they are those of the adjacent surface. Immutable; copies share the same data.
///
/// The parameters of a point are its place in a plane to which the patch is mapped one-to-one;
/// without such a map, u is the number of its triangle in the patch.
class FacetSurface {
 public:
  enum class Drawing { None, IfPossible };
  FacetSurface(const PatchedFacets& patched, const Patch& patch, Drawing drawing);

  /// Whether the surface of a patch, drawn as this one is, would be the same.
  bool isOf(const PatchedFacets& patched, const Patch& patch) const;
  bool isDrawn() const;
  /// The point at these parameters, if the patch is mapped to a plane; beyond the boundary the
  /// nearest place.
  SurfacePoint pointAt(double u, double v) const;
  /// With a smooth metric, perpendicular to the normal.
  SurfaceFrame frameAt(double u, double v) const;

  /// Where a line meets the patch: on the sheet of its base edge if that extends so far; else the
  /// place nearest to its start. If the line misses, e.g. next to a boundary of chords, the nearest
  /// point of the patch, if that is near.
  std::optional<SurfacePoint> hit(const SurfaceLine& line) const;
  /// The nearest point of the patch.
  SurfacePoint nearest(const Point3& position) const;
  /// The nearest point of one triangle, by its number in the patch.
  SurfacePoint nearestOn(std::uint32_t triangle, const Point3& position) const;
  /// The triangle on which a point of this surface lies, by its number in the patch, and the
  /// weights of its corners.
  struct Place {
    std::uint32_t triangle = 0;
    std::array<double, 3> weights{};
  };
  Place placeOf(const SurfacePoint& point) const;
  /// Interpolates values at the vertices linearly to the nearest point of the patch.
  ///
  /// values  by vertex of the facets
  double interpolated(const std::vector<double>& values, const Point3& position) const;
  double area() const;
  /// The area projected along the mean normal; what folds back is subtracted.
  double projectedArea() const;
  /// Calls visit(v, curvature) for each vertex of the facets that the patch uses: the rate at which
  /// its normals turn there per unit of length, as a mean over the triangles around it.
  template <class Visit>
  void forEachCurvature(const Visit& visit) const {
    for (std::size_t i = 0; i < usedVertices().size(); ++i)
      visit(usedVertices()[i], curvatures()[i]);
  }
  /// Calls visit(vertices of the facets, positions) for each triangle.
  template <class Visit>
  void forEachTriangle(const Visit& visit) const {
    for (std::size_t t = 0; t < triangleCount(); ++t) visit(verticesOf(t), positionsOf(t));
  }
  /// The plane that contains all of it, if there is one.
  std::optional<FlatSurface> plane() const;

 private:
  struct Data;
  const std::vector<std::uint32_t>& usedVertices() const;
  const std::vector<double>& curvatures() const;
  std::size_t triangleCount() const;
  std::array<std::uint32_t, 3> verticesOf(std::size_t triangle) const;
  std::array<Point3, 3> positionsOf(std::size_t triangle) const;
  std::shared_ptr<const Data> data_;
};

}  // namespace af2::geometry
