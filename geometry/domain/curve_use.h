// The curves that bound a face.
#pragma once

#include <cstddef>
#include <vector>

namespace af2::geometry {

/// One curve in the direction in which a face uses it, with the face on the left.
struct CurveUse {
  std::size_t curve = 0;
  bool reversed = false;
};
using CurveLoops = std::vector<std::vector<CurveUse>>;

}  // namespace af2::geometry
