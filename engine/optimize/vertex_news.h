// Remembers at which vertices of a changing mesh another look is worth while.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/ids.h"

namespace af2 {

/// A vertex is news if its surroundings have changed since the last look at it.
class VertexNews {
 public:
  /// All vertices are news at the beginning.
  explicit VertexNews(std::size_t vertices) : changed_(vertices, 1), lookedAt_(vertices, 0) {}

  bool isNews(VertexId v) const { return changed_[v.value] > lookedAt_[v.value]; }
  void look(VertexId v) { lookedAt_[v.value] = ++clock_; }
  /// vertices  of which the surroundings have changed
  /// count     the number of vertices that the mesh has now
  void noteChange(std::span<const VertexId> vertices, std::size_t count) {
    changed_.resize(count, 0);
    lookedAt_.resize(count, 0);
    ++clock_;
    for (const VertexId v : vertices) changed_[v.value] = clock_;
  }

 private:
  std::uint32_t clock_ = 1;                        ///< counts looks and changes
  std::vector<std::uint32_t> changed_, lookedAt_;  ///< by vertex: the time of the last
};

}  // namespace af2
