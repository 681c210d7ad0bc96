// Which process owns which element and vertex of a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/model_mesh.h"

namespace af2::mpi {

/// By element: the part, from 0. Parts have about the same number of elements and short borders.
/// The same mesh is divided in the same way each time.
///
/// Throws InputError if the mesh has too many elements for METIS.
std::vector<std::int32_t> divideMesh(const geometry::ModelMesh& mesh, int parts);

/// The mesh with its owners, and with the elements at each vertex.
class DividedMesh {
 public:
  /// mesh  must live as long as this
  DividedMesh(const geometry::ModelMesh& mesh, std::vector<std::int32_t> elementOwners, int parts);

  const geometry::ModelMesh& mesh() const { return mesh_; }
  int parts() const { return static_cast<int>(elementsOf_.size()); }
  const std::vector<std::uint32_t>& elementsOf(int part) const {
    return elementsOf_[static_cast<std::size_t>(part)];
  }
  std::int32_t ownerOfElement(std::uint32_t element) const { return elementOwners_[element]; }
  std::int32_t ownerOfVertex(std::uint32_t vertex) const { return vertexOwners_[vertex]; }
  /// Consecutive for each part.
  std::uint64_t numberOfElement(std::uint32_t element) const { return elementNumbers_[element]; }
  std::uint64_t numberOfVertex(std::uint32_t vertex) const { return vertexNumbers_[vertex]; }

  /// Calls visit(e) for each element at a corner of the given one, itself among them; some twice.
  void forEachBeside(std::uint32_t element, const auto& visit) const {
    for (const VertexId v : mesh_.elements[element].vertices())
      for (std::size_t i = begin_[v.value]; i < begin_[v.value + 1]; ++i) visit(around_[i]);
  }

 private:
  void findElementsAround();
  void findOwnersOfVertices();

  const geometry::ModelMesh& mesh_;
  std::vector<std::int32_t> elementOwners_, vertexOwners_;
  std::vector<std::vector<std::uint32_t>> elementsOf_;
  std::vector<std::uint64_t> elementNumbers_, vertexNumbers_;
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> around_;  ///< elements, by vertex
};

}  // namespace af2::mpi
