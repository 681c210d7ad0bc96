// The surface of faces that are meshed together.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/charts/layout_charts.h"
#include "geometry/faceted/facet_surface.h"
#include "geometry/occ/merge/background.h"
#include "geometry/occ/merge/face_grouping.h"
#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

/// What the surface of a quilt is made of; immutable, so threads may share it.
struct QuiltParts {
  std::shared_ptr<const ModelShape> model;
  FacetSurface facets;
  std::vector<int> faces;                         ///< ids, ascending
  std::vector<std::size_t> faceOf;                ///< by triangle: index in `faces`
  std::vector<std::array<Point2, 3>> parameters;  ///< by triangle, of its face
  /// By triangle: those beside it that are on other faces.
  std::vector<std::vector<std::uint32_t>> beside;
  std::vector<bool> isNarrow;  ///< by index of a face
};

/// triangles  of the background, all on `faces`
QuiltParts quiltPartsOf(std::shared_ptr<const ModelShape> model, const BackgroundFacets& background,
                        const std::vector<std::uint32_t>& triangles, std::vector<int> faces,
                        const FaceGrouping& grouping);

/// Triangles say which face a place is on, and where; the place itself is that of the CAD surface.
/// Normals are those of the faces, except on narrow ones, where they are those of the faces beside.
/// Parameters of points are those of FacetSurface. Not to be shared between threads, but each may
/// have a copy.
class QuiltSurface {
 public:
  explicit QuiltSurface(std::shared_ptr<const QuiltParts> parts);
  QuiltSurface(const QuiltSurface& other) : QuiltSurface(other.parts_) {}
  QuiltSurface& operator=(const QuiltSurface&) = delete;

  bool isDrawn() const { return parts_->facets.isDrawn(); }
  SurfacePoint pointAt(double u, double v) const;
  SurfaceFrame frameAt(double u, double v) const { return parts_->facets.frameAt(u, v); }
  std::optional<SurfacePoint> hit(const SurfaceLine& line) const;
  SurfacePoint nearest(const Point3& position) const;
  /// The nearest place on some of the triangles.
  SurfacePoint nearestAmong(std::span<const std::uint32_t> triangles, const Point3& position) const;

  /// A point as a point of the face under it.
  struct OnFace {
    std::size_t index = 0;  ///< in QuiltParts::faces
    SurfacePoint point;     ///< with OpenCASCADE's parameters
  };
  OnFace onFace(const SurfacePoint& point) const;
  /// The distance of a position from the surface of the face at the nearest place.
  double distanceFrom(const Point3& position) const;
  /// Moves a position that is on the surface of a face, but just beyond one of the edges that the
  /// mesh crosses, to the face beyond: triangles know curved edges only nearly.
  Point3 settled(const Point3& position) const;
  const FaceSurface& surfaceOf(std::size_t index) const;
  const QuiltParts& parts() const { return *parts_; }

 private:
  Point2 parametersAt(const FacetSurface::Place& place) const;
  SurfacePoint lifted(SurfacePoint point) const;
  SurfacePoint lifted(SurfacePoint point, const OnFace& on) const;

  std::shared_ptr<const QuiltParts> parts_;
  mutable std::vector<std::unique_ptr<const FaceSurface>> surfaces_;  // by index of a face
};

/// Those of patches of triangles.
using QuiltCharts = LayoutCharts<QuiltSurface>;

}  // namespace af2::geometry
