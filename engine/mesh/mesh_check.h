// Checks a mesh: conforming, correctly oriented, with the given boundary.
#pragma once

#include <string>
#include <vector>

#include "engine/base/export.h"
#include "engine/mesh/front_input.h"
#include "engine/mesh/mesh.h"

namespace af2 {

/// One fault of a mesh, with its place.
struct MeshFault {
  enum class Kind {
    BadElement,       ///< an element repeats a vertex or names an unknown one
    OverlappingEdge,  ///< two elements use an edge in the same direction
    OpenEdge,         ///< an inner edge has an element on one side only
    BoundaryNotKept,  ///< a boundary edge has no element on its left, or one on its right
    Inverted,         ///< an element's corner turns against the surface normal, or its own area
    UnusedVertex,     ///< a vertex is used by no element
  };
  Kind kind;
  ElementId element;  ///< the element at fault, if any
  VertexId from, to;  ///< the edge at fault; `from` alone: the vertex
  bool operator==(const MeshFault&) const = default;
};

/// One line that describes the fault and its place.
AF2_EXPORT std::string describe(const MeshFault& fault, const Mesh& mesh);

/// All faults of a mesh that should fill the region inside a boundary; empty if it is sound.
AF2_EXPORT std::vector<MeshFault> checkMesh(const Mesh& mesh, const MeshBoundary& boundary);
inline std::vector<MeshFault> checkMesh(const Mesh& mesh, const FrontInput& input) {
  return checkMesh(mesh, boundaryOf(input));
}

/// The number of faults of a mesh and a description of the first; empty if it is sound.
AF2_EXPORT std::string faultOf(const Mesh& mesh, const MeshBoundary& boundary);

}  // namespace af2
