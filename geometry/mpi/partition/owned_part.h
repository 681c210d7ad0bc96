// The part of a mesh that one process owns, with copies of what lies beside it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/point.h"
#include "engine/mesh/mesh.h"
#include "geometry/io/line_elements.h"

namespace af2::mpi {

class Crew;

/// A line element along an edge of the model.
struct OwnedLine {
  VertexId from, to, middle;  ///< indices of vertices of the part; middle: only of second order
  std::uint64_t id = 0;       ///< among the lines of the whole mesh
  std::int32_t edge = 0;      ///< of the model
};

/// What the parts of a mesh are called: the physical groups of Gmsh's format.
struct PartLabels {
  struct Entity {
    std::int32_t id = 0;               ///< of a face or edge of the model
    std::vector<std::int32_t> groups;  ///< numbers, its own first
  };
  std::vector<Entity> faces, edges;  ///< ascending
  struct Name {
    std::int32_t dimension = 2, group = 0;
    std::string name;
  };
  std::vector<Name> names;
};

/// Each element belongs to one process, and each vertex to one of those that have an element with
/// it. A part has all elements that share a vertex with one of its own: those of other processes
/// are its ghosts.
///
/// An index counts from 0 in the part. An id counts from 0 in the whole mesh, in the order of the
/// files of `af2 mesh`. A number counts from 0 in the whole mesh, too, but such that each process
/// owns consecutive numbers, as PETSc and others want it.
struct OwnedPart {
  std::int32_t process = 0, processes = 1;
  std::uint64_t allVertices = 0, allElements = 0, allLines = 0;  ///< of the whole mesh

  std::vector<Point3> vertices;  ///< those that this process owns come first
  std::size_t ownedVertices = 0;
  std::vector<std::uint64_t> vertexIds, vertexNumbers;
  std::vector<std::int32_t> vertexOwners;  ///< by vertex: the process

  std::vector<Element> elements;  ///< corners are indices; those of this process come first
  std::size_t ownedElements = 0;
  std::vector<std::uint64_t> elementIds, elementNumbers;
  std::vector<std::int32_t> elementOwners;
  std::vector<std::int32_t> face;                 ///< by element: id of the model face
  std::vector<std::array<VertexId, 4>> midsides;  ///< by element, of second order; else empty
  /// The processes to which own element e is a ghost, ascending: ghostsOf[i] for i from
  /// ghostsBegin[e] to before ghostsBegin[e + 1].
  std::vector<std::size_t> ghostsBegin;
  std::vector<std::int32_t> ghostsOf;

  std::vector<OwnedLine> lines;  ///< of this process
  PartLabels labels;
};

/// Divides a mesh into as many parts as the crew has processes, by METIS, and gives each process
/// its own. All processes call it; the mesh counts on rank 0 only. A mesh that has been put away
/// (ModelMesh::spooled) is loaded face by face. The crew must live as long as such a mesh.
OwnedPart distribute(Crew& crew, const geometry::ModelMesh& mesh, geometry::LinesAlong lines);

}  // namespace af2::mpi
