// Wanted sizes that grow gently away from the short segments of a boundary.
#pragma once

#include <memory>

#include "engine/base/export.h"
#include "engine/mesh/front_input.h"
#include "engine/surface/size_field.h"
#include "geometry/sizes/growing_size.h"

namespace af2::geometry {

/// Most growth of sizes per unit of length, unless another one is asked for. At 0.4 there are a
/// tenth fewer elements, but those between small and large ones are visibly worse.
constexpr double kDefaultGrowth = 0.3;

/// `wanted`, but near short segments of the boundary no more than what grows from them, and near
/// segments that are far too long no less than what shrinks away from these: the front has to come
/// from their length down to the wanted one in steps.
class AF2_EXPORT GradedSize final : public SizeField {
 public:
  GradedSize(const SizeField& wanted, const FrontInput& boundary, double growth);
  /// For another thread, whose field `wanted` gives the same sizes as that of `other`.
  GradedSize(const SizeField& wanted, const GradedSize& other);
  double sizeAt(const SurfacePoint& point) const override;

 private:
  struct Slopes {
    GrowingSize growing;
    GrowingSize shrinking;  ///< of sizes with the other sign
  };

  const SizeField& wanted_;
  std::shared_ptr<const Slopes> slopes_;
};

}  // namespace af2::geometry
