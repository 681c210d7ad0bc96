// One round of retries: divides the edges as remedies request, and meshes the affected faces again.
// Not installed.
#pragma once

#include <vector>

#include "geometry/retry/remedy.h"

namespace af2::geometry {

/// Meshes the given faces and those at edges that changed, and takes over the others. The history
/// of each face is kept. The meshes are not joined yet.
///
/// faces  in ascending order
FaceMeshes meshAgain(Retrial& retrial, const FaceMeshes& state,
                     const std::vector<std::size_t>& faces);

/// Joins the meshes, and applies the remedies for joined meshes.
void joinWithRemedies(const Retrial& retrial, FaceMeshes& state);

}  // namespace af2::geometry
