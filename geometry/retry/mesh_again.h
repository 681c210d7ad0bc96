// One round: edges divided as remedies ask for, and the faces concerned meshed anew.
// Not installed.
#pragma once

#include <vector>

#include "geometry/retry/remedy.h"

namespace af2::geometry {

/// Meshes the faces that are named and those at edges that changed; takes over the others. What is
/// behind a face stands in its history. The meshes are not joined yet.
///
/// faces  in ascending order
FaceMeshes meshAgain(Retrial& retrial, const FaceMeshes& state,
                     const std::vector<std::size_t>& faces);

/// Joins the meshes, with the remedies for joined meshes.
void joinWithRemedies(const Retrial& retrial, FaceMeshes& state);

}  // namespace af2::geometry
