// Keeps only what passes the checks: the last look at a mesh before it is written.
#pragma once

#include <string>
#include <vector>

#include "geometry/element_crossings.h"
#include "geometry/model_mesh.h"

namespace af2::geometry {

/// Checks `mesh`. Each face with a finding becomes Failed, with the finding as its reason, and its
/// elements and the vertices that only they use are taken out; so do as many faces as it takes to
/// leave none of the `crossings` (elementCrossings). Returns in words what else was found, of the
/// mesh as a whole.
std::vector<std::string> keepSoundFaces(ModelMesh& mesh,
                                        const std::vector<Crossing>& crossings = {});

/// Takes out the elements of `faces` (ids in ascending order) and the vertices that no element uses
/// then. What stays keeps its order.
void dropElements(ModelMesh& mesh, const std::vector<int>& faces);

}  // namespace af2::geometry
