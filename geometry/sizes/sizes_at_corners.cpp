#include "geometry/sizes/sizes_at_corners.h"

#include <array>
#include <bit>

namespace af2::geometry {

namespace {

/// Compared instead of numbers, so that even those that are none are found again.
using Bits = std::array<std::uint64_t, sizeof(SurfacePoint) / sizeof(double)>;

/// The upper bits of the product depend on all bits of the place.
std::uint64_t mixed(const Bits& bits) {
  constexpr std::uint64_t kFactor = 0x9E3779B97F4A7C15;
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < 3; ++i) all = (std::rotl(all, 23) ^ bits[i]) * kFactor;
  return all;
}

}  // namespace

SizesAtCorners::SizesAtCorners(const FrontInput& boundary) {
  std::size_t count = 0;
  for (const auto& loop : boundary.loops) count += loop.size();
  corners_.reserve(count);
  slots_.assign(std::bit_ceil(2 * count + 2), 0);
  for (const auto& loop : boundary.loops)
    for (const BoundaryCorner& corner : loop) {
      std::uint32_t& slot = slots_[slotOf(corner.point)];
      if (slot != 0) continue;
      corners_.push_back({corner.point, {}});
      slot = static_cast<std::uint32_t>(corners_.size());
    }
}

/// That of a corner, or the empty one where it would be.
std::size_t SizesAtCorners::slotOf(const SurfacePoint& point) const {
  const Bits bits = std::bit_cast<Bits>(point);
  const int shift = 64 - std::countr_zero(slots_.size());
  std::size_t slot = mixed(bits) >> shift;
  while (slots_[slot] != 0 && std::bit_cast<Bits>(corners_[slots_[slot] - 1].point) != bits)
    slot = (slot + 1) % slots_.size();
  return slot;
}

const SizesAtCorners::Sizes* SizesAtCorners::find(const SurfacePoint& point) const {
  const std::uint32_t found = slots_[slotOf(point)];
  return found == 0 ? nullptr : &corners_[found - 1].sizes;
}

}  // namespace af2::geometry
