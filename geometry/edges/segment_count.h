// The number of segments of an edge, and how far it may be changed.
// Not installed.
#pragma once

#include <cstddef>
#include <vector>

namespace af2::geometry {

/// An edge, or a part of one that is divided by itself.
struct SegmentCount {
  double wanted = 0;         ///< the number of segments if all had exactly the wanted sizes, > 0
  std::size_t segments = 1;  ///< the number it has
  std::size_t least = 1;     ///< it may not have fewer
  bool isFixed = false;      ///< its division is given
};

/// By count: by how much the number of segments differs from the one by sizes alone.
/// Empty: no number differs.
using SegmentChanges = std::vector<int>;

inline int changeAt(const SegmentChanges& changes, std::size_t count) {
  return changes.empty() ? 0 : changes[count];
}

}  // namespace af2::geometry
