// Divides the vertices of a large mesh into blocks, each of which has few of the elements.
// Not installed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/parallel.h"
#include "engine/mesh/mesh.h"

namespace af2::geometry {

/// Some vertices of a mesh, in a row.
struct VertexRange {
  std::size_t begin, end;
  bool contains(std::size_t v) const { return v >= begin && v < end; }
};

/// What is known of all vertices of a large mesh would take more memory than the mesh and fit no
/// cache; what is known of a block does, and blocks can be looked at on several threads. Elements
/// have neighbouring vertices, so that most have vertices in one block or two.
class VertexBlocks {
 public:
  /// Uses up to `threads` threads (0: as many as the caller's TBB arena has). Corners that are not
  /// vertices are left out. The elements must outlive this.
  VertexBlocks(std::size_t vertices, std::span<const Element> elements, int threads);

  std::size_t count() const { return vertices_.count(); }
  VertexRange operator[](std::size_t block) const {
    const auto range = vertices_[block];
    return {range.front(), range.back() + 1};
  }
  /// Calls visit(i) for each element i that may have a vertex in the block, in order.
  template <class Visit>
  void forEachElementAt(std::size_t block, const Visit& visit) const {
    for (std::size_t range = 0; range < elements_.count(); ++range)
      if (has_.empty() || has_[range][block])
        for (const std::size_t i : elements_[range]) visit(i);
  }

 private:
  static constexpr std::size_t kVertices = 1 << 16, kElements = 1 << 15;

  Ranges vertices_, elements_;
  std::vector<std::vector<std::uint8_t>> has_;  ///< by range of elements and block; not for one
};

}  // namespace af2::geometry
