// Keeps only what passes the checks: the last look at a mesh before it is written.
#pragma once

#include <string>
#include <vector>

#include "geometry/model_mesh.h"

namespace af2::geometry {

/// Checks `mesh`. Each face with a finding becomes Failed, with the finding as its reason, and its
/// elements and the vertices that only they use are taken out. Returns in words what else was
/// found, of the mesh as a whole.
std::vector<std::string> keepSoundFaces(ModelMesh& mesh);

/// Takes out the elements of `faces` (ids in ascending order) and the vertices that no element uses
/// then. What stays keeps its order.
void dropElements(ModelMesh& mesh, const std::vector<int>& faces);

}  // namespace af2::geometry
