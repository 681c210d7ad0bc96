// Volume entities of a mesh, for Gmsh's format.
// Not installed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

struct MshVolume {
  std::int32_t number = 0;  ///< as MeshVolume::solid
  std::string name;         ///< of the part that is this solid; else "solid 3"
  /// The faces that bound it, ascending by id; those that look into it are negative.
  std::vector<std::int32_t> surfaces;
};

/// One for each solid that the elements close, ascending by number.
std::vector<MshVolume> mshVolumes(const ModelMesh& mesh);

}  // namespace af2::geometry
