// Whether a mesh is what it should be: conforming, oriented, with the boundary as it was given.
#pragma once

#include <string>
#include <vector>

#include "engine/base/export.h"
#include "engine/mesh/front_input.h"
#include "engine/mesh/mesh.h"

namespace af2 {

/// What is wrong with a mesh, at one place.
struct MeshFault {
  enum class Kind {
    BadElement,       ///< an element repeats a vertex or names one that is not there
    OverlappingEdge,  ///< two elements use an edge in the same direction
    OpenEdge,         ///< an edge inside has an element on one side only
    BoundaryNotKept,  ///< a boundary edge has no element on its left, or one on its right
    Inverted,         ///< an element's corner turns against the surface normal
    UnusedVertex,     ///< a vertex is used by no element
  };
  Kind kind;
  ElementId element;  ///< if one is at fault
  VertexId from, to;  ///< the edge at fault; `from` alone: the vertex
  bool operator==(const MeshFault&) const = default;
};

/// One line that tells the fault and its place.
AF2_EXPORT std::string describe(const MeshFault& fault, const Mesh& mesh);

/// All faults of a mesh that should fill the region inside a boundary; none: the mesh is sound.
AF2_EXPORT std::vector<MeshFault> checkMesh(const Mesh& mesh, const MeshBoundary& boundary);
inline std::vector<MeshFault> checkMesh(const Mesh& mesh, const FrontInput& input) {
  return checkMesh(mesh, boundaryOf(input));
}

/// How many faults a mesh has, and the first in words; empty: it is sound.
AF2_EXPORT std::string faultOf(const Mesh& mesh, const MeshBoundary& boundary);

}  // namespace af2
