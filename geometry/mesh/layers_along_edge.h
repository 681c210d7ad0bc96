// The layers that a face got along one of its edges.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/point.h"

namespace af2::geometry {

struct LayersAlongEdge {
  int edge = 0;              ///< id
  std::size_t asked = 0;     ///< layers
  std::size_t fewest = 0;    ///< above one of its segments
  std::size_t most = 0;      ///< above one of its segments
  std::size_t segments = 0;  ///< of the edge
  std::size_t fewer = 0;     ///< those with fewer layers than asked, because there is no more room
  Point3 place = {};        ///< middle of a segment with the fewest layers, where they are thinnest
  std::size_t thinner = 0;  ///< segments with thinner layers than asked
  double thinnest = 1;      ///< the least share of the heights asked for
};

}  // namespace af2::geometry
