// Wanted sizes that grow gently away from the short segments of a boundary.
#pragma once

#include <vector>

#include "engine/front_input.h"
#include "engine/size_field.h"
#include "geometry/growing_size.h"

namespace af2::geometry {

/// Most growth of sizes per unit of length, unless another one is asked for. At 0.4 there are a
/// tenth fewer elements, but those between small and large ones are visibly worse.
constexpr double kDefaultGrowth = 0.3;

/// The corners of a boundary at which it is divided more finely than `wanted` asks for.
std::vector<SizeSource> shortSegments(const FrontInput& boundary, const SizeField& wanted);

/// `wanted`, but near short segments of the boundary no more than what grows from them, and near
/// segments that are far too long no less than what shrinks away from these: the front has to come
/// from their length down to the wanted one in steps.
class GradedSize final : public SizeField {
 public:
  GradedSize(const SizeField& wanted, const FrontInput& boundary, double growth);
  double sizeAt(const SurfacePoint& point) const override;

 private:
  const SizeField& wanted_;
  GrowingSize growing_;
  GrowingSize shrinking_;  ///< of sizes with the other sign
};

}  // namespace af2::geometry
