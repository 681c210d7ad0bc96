// Fills a ring of vertices with quadrilaterals.
#pragma once

#include <array>
#include <vector>

#include "engine/optimize/ring_plans.h"

namespace af2 {

struct RingFilling {
  std::vector<std::array<std::size_t, 4>> quads;  ///< vertices of the ring first, then new ones
  std::vector<Point2> points;                     ///< of all vertices
};

/// New vertices lie on straight lines where the plan has lines, and between them otherwise.
RingFilling fillRing(const Ring& ring, const FillingPlan& plan);

}  // namespace af2
