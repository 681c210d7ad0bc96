// Builds the region of a shape.
#pragma once

#include "dsl/shapes/region.h"
#include "dsl/shapes/shape.h"

namespace af2::dsl::shapes {

struct Built {
  Region region;
  Box2 box;  ///< contains the region; may be infinite in directions that half planes do not bound
  Refusal refusal = Refusal::None;
  const char* reason = "";
  bool growsWithoutBounds = false;  ///< refused because the shape inside `grow` is unbounded
};

/// The region of a shape, bounded or not; or the reason why it has none.
Built build(const Shape& shape);

/// Whether a region is bounded. Exact.
bool isBounded(const Region& region);

/// A finite box for a bounded region: `box`, or the box of its boundary if `box` is infinite.
Box2 finiteBox(const Region& region, const Box2& box);

}  // namespace af2::dsl::shapes
