// Points of faces between curves: those with given parameters, and those nearest to given points.
#pragma once

#include <vector>

#include "engine/base/export.h"
#include "geometry/domain/domain_model.h"

namespace af2::geometry {

/// A point of a face, within its curves.
struct PointInDomain {
  SurfacePoint point;
  int face = 0;         ///< id; 0: none was found
  double distance = 0;  ///< from the point for which it was searched
};

/// Searches points of a model, which must outlive it. Threads may share it if they may share the
/// surfaces.
class AF2_EXPORT PointsInDomain {
 public:
  explicit PointsInDomain(const DomainModel& model);

  /// Throws InputError for a face that the model does not have, and GeometryError where its surface
  /// has no point.
  SurfacePoint at(int face, double u, double v) const;
  /// The nearest point of a face, or of all faces (0); the first of equally near ones. Throws
  /// InputError for a face that the model does not have.
  PointInDomain nearest(const Point3& point, int face = 0) const;

 private:
  const DomainFace& faceOf(int face) const;
  PointInDomain onFace(const Point3& point, int face) const;
  bool isInside(int face, Point2 parameters) const;

  using Polygon = std::vector<Point2>;
  const DomainModel& model_;
  /// By face: its loops in the parameters of its surface. None: the surface ends where the face
  /// does.
  std::vector<std::vector<Polygon>> loops_;
};

}  // namespace af2::geometry
