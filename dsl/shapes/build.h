// From a shape as written to the region that answers for it.
#pragma once

#include "dsl/shapes/region.h"
#include "dsl/shapes/shape.h"

namespace af2::dsl::shapes {

struct Built {
  Region region;
  Box2 box;  ///< holds the region; infinite where half planes leave it so
  Refusal refusal = Refusal::None;
  const char* reason = "";
  bool growsWithoutBounds = false;  ///< refused because what is to be grown has no bounds
};

/// The region of a shape, bounded or not; or why it has none.
Built build(const Shape& shape);

/// Whether a region lies in some box. Exact.
bool isBounded(const Region& region);

/// A finite box for a bounded region: `box`, or one drawn around its boundary if that is infinite.
Box2 finiteBox(const Region& region, const Box2& box);

}  // namespace af2::dsl::shapes
