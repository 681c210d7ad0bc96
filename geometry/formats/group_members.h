// What belongs to each group of a mesh, for formats that list it.
// Not installed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/formats/msh_groups.h"

namespace af2::geometry {

struct GroupMembers {
  PhysicalGroup group;
  std::string name;
  std::vector<std::uint32_t> members;  ///< indices of lines or elements, ascending
};

/// Groups of curves with lines, then groups of surfaces with elements, each by number.
std::vector<GroupMembers> groupMembers(const ModelMesh& mesh, Lines lines, const MshGroups& groups);

/// By element: the number of the first group of its face.
std::vector<std::int32_t> firstGroups(const ModelMesh& mesh, const MshGroups& groups);

/// Elements of one kind that belong to a group first.
struct ElementBlock {
  std::int32_t group = 0;
  bool isQuad = false;
  std::vector<std::uint32_t> elements;  ///< ascending
};

/// Each element is in one. By group, triangles first.
std::vector<ElementBlock> elementBlocks(const ModelMesh& mesh, const MshGroups& groups);

/// The vertices of the members, ascending, each once.
std::vector<VertexId> verticesOf(const ModelMesh& mesh, Lines lines, const GroupMembers& group);

/// By vertex: whether an element uses it, as a corner or at the middle of a side.
std::vector<bool> usedVertices(const ModelMesh& mesh);

/// A side of an element: [0] is between corners 0 and 1.
struct ElementSide {
  std::uint32_t element = 0, side = 0;
};

/// By line: the side that it is; of several the one of the first element.
std::vector<ElementSide> sidesOnLines(const ModelMesh& mesh, Lines lines);

}  // namespace af2::geometry
