// Keeps only the faces that pass the last checks of a mesh before it is written.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "geometry/check/element_crossings.h"
#include "geometry/check/model_check.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Enough findings to find every bad face of a model, and no more than fit into the memory.
inline constexpr std::size_t kMaxFindings = 1'000'000;

/// The findings of the checks of a mesh.
struct MeshFaults {
  std::vector<MeshFinding> findings;  ///< of checkModelMesh
  std::vector<Crossing> crossings;    ///< elementCrossings
};

/// Runs both checks in parallel. Without `mayCross`, crossings are not searched for.
AF2_EXPORT MeshFaults faultsOf(const ModelMesh& mesh, bool mayCross, int threads);

/// Each face with a finding becomes Failed, with the finding as its reason; its elements and the
/// vertices that only they use are removed. The same is done to as many faces as are needed to
/// leave no crossings. If no elements are left, all faces are Failed. Returns messages for the
/// findings that concern the mesh as a whole.
AF2_EXPORT std::vector<std::string> keepSoundFaces(ModelMesh& mesh, const MeshFaults& faults);

/// Removes the elements of `faces` (ids in ascending order) and the vertices that no element uses
/// then. The rest keeps its order.
AF2_EXPORT void dropElements(ModelMesh& mesh, const std::vector<int>& faces);

}  // namespace af2::geometry
