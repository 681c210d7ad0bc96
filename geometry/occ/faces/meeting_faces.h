// Faces whose elements cross because the faces themselves do, in the model.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <optional>
#include <vector>

#include "geometry/check/element_crossings.h"
#include "geometry/mesh/model_mesh.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// A point that two faces have in common inside.
struct CommonPoint {
  Point3 place;
  bool isTouching =
      false;  ///< there the faces lie on each other; else one passes through the other
};

/// A common point of two faces, sought from a place nearby, that is farther than `away` from the
/// edges of both. None if the search ends elsewhere.
std::optional<CommonPoint> commonPoint(const ModelShape& model, int one, int other,
                                       const Point3& nearby, double away);

/// Adds to the reasons of faces that failed, because their elements cross those of others, where
/// the faces themselves do: no mesh can be sound there.
///
/// size  edge length of the mesh
void tellOfMeetingFaces(const ModelShape& model, const std::vector<Crossing>& crossings,
                        double size, std::vector<FaceReport>& faces);

}  // namespace af2::geometry
