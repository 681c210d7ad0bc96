// The elements at each vertex while the front advances, for acts that move or join vertices.
// Not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.h"

namespace af2 {

/// Lists through the corners of the elements: an element has four entries, one for each corner.
class VertexElements {
 public:
  /// Enters the elements of the mesh from this one on.
  void enter(const Mesh& mesh, std::size_t firstElement) {
    first_.resize(mesh.vertices.size(), kNone);
    next_.resize(4 * mesh.elements.size(), kNone);
    for (std::size_t e = firstElement; e < mesh.elements.size(); ++e)
      for (std::size_t c = 0; c < static_cast<std::size_t>(mesh.elements[e].size()); ++c) {
        std::uint32_t& first = first_[mesh.elements[e].corners[c].value];
        next_[4 * e + c] = first;
        first = static_cast<std::uint32_t>(4 * e + c);
      }
  }

  /// Calls visit(element, corner) for each element at a vertex, the newest first.
  template <class Visit>
  void forEachAt(VertexId v, Visit&& visit) const {
    if (v.value >= first_.size()) return;
    for (std::uint32_t c = first_[v.value]; c != kNone; c = next_[c])
      visit(std::size_t{c} / 4, std::size_t{c} % 4);
  }

  /// All elements at one vertex are now at another. Vertices of a path may have none yet.
  void give(VertexId from, VertexId into) {
    if (from.value >= first_.size()) return;
    if (into.value >= first_.size()) first_.resize(into.value + 1, kNone);
    std::uint32_t* last = &first_[from.value];
    if (*last == kNone) return;
    while (*last != kNone) last = &next_[*last];
    *last = first_[into.value];
    first_[into.value] = first_[from.value];
    first_[from.value] = kNone;
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> first_;  // by vertex
  std::vector<std::uint32_t> next_;   // by element and corner
};

}  // namespace af2
