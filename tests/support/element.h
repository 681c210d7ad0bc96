// Elements made of numbers, for tests.
#pragma once

#include <initializer_list>

#include "engine/mesh/mesh.h"

namespace af2::testing {

inline VertexId v(std::size_t i) { return VertexId(i); }

/// One with these corners, three or four.
inline Element elementOf(std::initializer_list<std::size_t> corners) {
  Element element;
  std::size_t i = 0;
  for (const std::size_t corner : corners) element.corners[i++] = VertexId(corner);
  return element;
}

}  // namespace af2::testing
