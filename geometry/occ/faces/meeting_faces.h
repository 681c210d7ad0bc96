// Finds faces whose elements cross because the faces themselves cross in the model, or almost do.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/check/element_crossings.h"
#include "geometry/mesh/model_mesh.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// A common point in the interior of two faces.
struct CommonPoint {
  Point3 place;
  bool isTouching = false;  ///< true: the faces overlap there; false: they cross
};

/// A common point of two faces that is farther than `away` from the edges of both, found by a
/// search from a place nearby. None if the search does not converge to such a point.
std::optional<CommonPoint> commonPoint(const ModelShape& model, int one, int other,
                                       const Point3& nearby, double away);

/// Words for where a face meets another one in the model itself, or encloses an angle below 0.3
/// degrees with it at an edge; empty if that is not so.
///
/// crossings  of elements of the face with those of others: where to look
/// size       edge length of the mesh
std::string meetingOf(const ModelShape& model, int face, const std::vector<Crossing>& crossings,
                      double size);

/// Where faces failed because their elements cross those of other faces, and the faces themselves
/// cross, adds this to the reasons: no mesh can be valid there. So it does where faces that failed
/// enclose an angle below 0.3 degrees with another face at an edge.
///
/// size  edge length of the mesh
void tellOfMeetingFaces(const ModelShape& model, const std::vector<Crossing>& crossings,
                        double size, std::vector<FaceReport>& faces);

}  // namespace af2::geometry
