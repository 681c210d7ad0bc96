#include "geometry/mesh/vertex_blocks.h"

namespace af2::geometry {

VertexBlocks::VertexBlocks(std::size_t vertices, std::span<const Element> elements, int threads)
    : vertices_(vertices, kVertices), elements_(elements.size(), kElements) {
  if (vertices_.count() <= 1) return;
  has_.resize(elements_.count());
  forEachInParallel(has_.size(), threads, [&](std::size_t range) {
    std::vector<std::uint8_t>& has = has_[range];
    has.resize(vertices_.count());
    for (const std::size_t i : elements_[range])
      for (const VertexId v : elements[i].vertices())
        if (v.value < vertices) has[v.value / kVertices] = 1;
  });
}

}  // namespace af2::geometry
