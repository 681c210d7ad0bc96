// A mesh with its groups as plain data, for writers that are libraries of their own.
// Not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/formats/group_members.h"

namespace af2::geometry {

struct GroupedMesh {
  const ModelMesh& mesh;
  Lines lines;
  std::vector<GroupMembers> groups;  ///< of curves, then of surfaces
  std::vector<ElementBlock> blocks;
  std::vector<ElementSide> sides;  ///< by line
};

}  // namespace af2::geometry
