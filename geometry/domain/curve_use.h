// Which curves bound a face.
#pragma once

#include <cstddef>
#include <vector>

namespace af2::geometry {

/// One curve as a face runs along it, with the face on the left.
struct CurveUse {
  std::size_t curve = 0;
  bool reversed = false;
};
using CurveLoops = std::vector<std::vector<CurveUse>>;

}  // namespace af2::geometry
