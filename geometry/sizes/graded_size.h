// Grades wanted sizes away from the short segments of a boundary.
#pragma once

#include <memory>

#include "engine/base/export.h"
#include "engine/mesh/front_input.h"
#include "engine/surface/size_field.h"
#include "geometry/sizes/growing_size.h"

namespace af2::geometry {

/// Default of the largest growth of sizes per unit of length. At 0.4 there are a tenth fewer
/// elements, but those between small and large ones are visibly worse.
constexpr double kDefaultGrowth = 0.3;

/// The sizes of `wanted`, limited near short segments of the boundary to sizes that grow from
/// these; and near segments that are far too long raised to sizes that shrink away from these,
/// because the front has to go from their length to the wanted one in steps.
class AF2_EXPORT GradedSize final : public SizeField {
 public:
  GradedSize(const SizeField& wanted, const FrontInput& boundary, double growth);
  /// A copy for another thread, whose field `wanted` gives the same sizes as that of `other`.
  GradedSize(const SizeField& wanted, const GradedSize& other);
  double sizeAt(const SurfacePoint& point) const override;
  /// That of the given field, before it is graded.
  double ungradedAt(const SurfacePoint& point) const;

 private:
  struct Slopes;

  const SizeField& wanted_;
  std::shared_ptr<const Slopes> slopes_;
};

/// The field that a graded one was made of, with the sizes that are known at the corners.
class UngradedSize final : public SizeField {
 public:
  explicit UngradedSize(const GradedSize& graded) : graded_(graded) {}
  double sizeAt(const SurfacePoint& point) const override { return graded_.ungradedAt(point); }

 private:
  const GradedSize& graded_;
};

}  // namespace af2::geometry
