// Keeps only what passes the checks: the last look at a mesh before it is written.
#pragma once

#include <string>
#include <vector>

#include "engine/base/export.h"
#include "geometry/check/element_crossings.h"
#include "geometry/check/model_check.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// What the checks of a mesh have found.
struct MeshFaults {
  std::vector<MeshFinding> findings;  ///< of checkModelMesh
  std::vector<Crossing> crossings;    ///< elementCrossings
};

/// Both checks, one beside the other. Without `mayCross` no crossings are looked for.
AF2_EXPORT MeshFaults faultsOf(const ModelMesh& mesh, bool mayCross, int threads);

/// Each face with a finding becomes Failed, with the finding as its reason, and its elements and
/// the vertices that only they use are taken out; so do as many faces as it takes to leave no
/// crossings. If no elements are left, all faces are Failed. Returns in words what else was found,
/// of the mesh as a whole.
AF2_EXPORT std::vector<std::string> keepSoundFaces(ModelMesh& mesh, const MeshFaults& faults);

/// Takes out the elements of `faces` (ids in ascending order) and the vertices that no element uses
/// then. What stays keeps its order.
AF2_EXPORT void dropElements(ModelMesh& mesh, const std::vector<int>& faces);

}  // namespace af2::geometry
