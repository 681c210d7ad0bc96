// How the elements of a mesh hang together: which sides are boundaries of faces, the elements
// around each vertex between two boundaries, and the regions inside them.
// Not installed.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/mesh/mesh_sides.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// The elements around a vertex from one boundary to the next, counter-clockwise; or all of them,
/// if no boundary is there.
struct Fan {
  VertexId vertex;
  std::uint32_t region = 0;            ///< that the elements are in
  bool isClosed = false;               ///< no boundary ends at the vertex
  std::vector<std::uint32_t> corners;  ///< 4 * element + index of the corner in the element
};

struct EdgeCounts {
  std::size_t all = 0;
  std::size_t free = 0;         ///< of one element
  std::size_t nonManifold = 0;  ///< of more than two elements
  std::size_t turned = 0;       ///< of two elements with opposite orientation
  std::size_t folded = 0;       ///< inside a face, with normals more than 90 degrees apart
  std::size_t boundary = 0;     ///< that bound a face or region, the first three kinds among them
};

class MeshFans {
 public:
  /// Boundaries are edges of one element, of more than two, between elements of different faces or
  /// of opposite orientation, and those along which mesh.segments run.
  ///
  /// featureDegrees  edges at which the surface turns by more than this are boundaries, too
  MeshFans(const ModelMesh& mesh, double featureDegrees);

  const std::vector<Fan>& fans() const { return fans_; }
  const EdgeCounts& edges() const { return edges_; }
  /// The ends of all boundary edges, the lower vertex first.
  const std::vector<std::pair<VertexId, VertexId>>& boundaryEdges() const { return boundary_; }
  std::size_t regions() const { return regions_; }
  std::uint32_t regionOf(std::size_t element) const { return region_[element]; }
  /// Pieces of the mesh that no edge joins.
  std::size_t components() const { return components_; }

 private:
  /// Counts an edge with these sides. Returns whether it is a boundary.
  bool countEdge(const ModelMesh& mesh, std::span<const MeshSide> sides, bool isKept,
                 double leastCosine);
  void joinElements(const ModelMesh& mesh, double featureDegrees);
  void numberRegions(std::size_t elements);
  void collectFans(const ModelMesh& mesh);

  std::vector<std::uint32_t> across_;  // by side, 4 * element + index: the side beyond
  std::vector<std::uint32_t> region_;  // by element
  std::vector<Fan> fans_;
  std::vector<std::pair<VertexId, VertexId>> boundary_;
  EdgeCounts edges_;
  std::size_t regions_ = 0, components_ = 0;
};

}  // namespace af2::geometry
