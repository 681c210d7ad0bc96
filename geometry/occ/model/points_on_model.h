// Points of the faces of a CAD model: those with given parameters, and those nearest to given
// points.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/base/export.h"
#include "geometry/occ/model/model.h"

namespace af2::geometry {

/// A point of a face. Its parameters are those of the surface in OpenCASCADE, and so those of other
/// programs that read the same file.
struct PointOnModel {
  SurfacePoint point;
  int face = 0;         ///< id
  double distance = 0;  ///< from the point for which it was searched
};

/// The points of a face with the given parameters. The surface may continue beyond the edges of the
/// face.
///
/// Throws InputError for a face that the model does not have or that has no surface, and for
/// parameters outside the range of the surface.
AF2_EXPORT std::vector<PointOnModel> pointsAt(const Model& model, int face,
                                              std::span<const Point2> parameters);

/// For each of the points, the nearest point of the model; it may be on an edge.
///
/// faces    by point: the id of the face on which the nearest point is searched; 0, or empty: all
///          faces, which takes longer
/// threads  0: as many as the machine has. The result does not depend on it.
///
/// Throws InputError if there are neither as many faces as points nor none, for a face that the
/// model does not have, and for a point without finite coordinates. A point with no nearest point,
/// because OpenCASCADE fails on all faces in question, gets the face 0 and keeps its position.
AF2_EXPORT std::vector<PointOnModel> nearestPoints(const Model& model,
                                                   std::span<const Point3> points,
                                                   std::span<const int> faces = {},
                                                   int threads = 0);

}  // namespace af2::geometry
