// Patches in a plane, which are quickly told apart.
// Not installed.
#pragma once

#include <optional>

#include "geometry/check/patch_outline.h"

namespace af2::geometry {

/// Where the elements of a patch lie along the normal of their plane.
struct FlatPatch {
  Point3 normal;
  double low = 0, high = 0;
};

/// Nothing if the elements of a patch do not lie in one plane, to half of a depth.
std::optional<FlatPatch> flatPatchOf(const ModelMesh& mesh, const OutlinedPatch& patch,
                                     double depth);

/// Whether two patches certainly do not reach into each other by more than a depth, nor have
/// elements that overlap at a common edge: their planes meet at an angle, and one of them is on one
/// side of the plane of the other. False proves nothing.
bool arePartedByAPlane(const ModelMesh& mesh, const OutlinedPatch& one, const FlatPatch& flatOne,
                       const OutlinedPatch& other, const FlatPatch& flatOther, double depth);

}  // namespace af2::geometry
