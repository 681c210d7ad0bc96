#include "geometry/sizes/sizes_at_corners.h"

#include <array>
#include <bit>

namespace af2::geometry {

namespace {

/// Compared instead of numbers, so that even those that are none are found again.
bool areSame(const SurfacePoint& one, const SurfacePoint& other) {
  using Bits = std::array<std::uint64_t, sizeof(SurfacePoint) / sizeof(double)>;
  return std::bit_cast<Bits>(one) == std::bit_cast<Bits>(other);
}

/// The upper bits of the products depend on all bits of the place.
std::uint64_t mixed(const Point3& place) {
  constexpr std::uint64_t kFactor = 0x9E3779B97F4A7C15;
  std::uint64_t all = 0;
  for (const double coordinate : {place.x, place.y, place.z})
    all = (std::rotl(all, 23) ^ std::bit_cast<std::uint64_t>(coordinate)) * kFactor;
  return all;
}

}  // namespace

SizesAtCorners::SizesAtCorners(const FrontInput& boundary) {
  std::size_t count = 0;
  for (const auto& loop : boundary.loops) count += loop.size();
  corners_.reserve(count);
  slots_.assign(std::bit_ceil(2 * count + 2), {});
  for (const auto& loop : boundary.loops)
    for (const BoundaryCorner& corner : loop) {
      const Found found = search(corner.point);
      Slot& slot = slots_[found.slot];
      if (slot.number != 0) continue;
      corners_.push_back({corner.point, {}});
      slot = {static_cast<std::uint32_t>(corners_.size()), found.tag};
    }
}

SizesAtCorners::Found SizesAtCorners::search(const SurfacePoint& point) const {
  const std::uint64_t all = mixed(point.position);
  const auto tag = static_cast<std::uint32_t>(all);
  std::size_t at = all >> (64 - std::countr_zero(slots_.size()));
  const auto isThere = [&](const Slot& slot) {
    return slot.tag == tag && areSame(corners_[slot.number - 1].point, point);
  };
  while (slots_[at].number != 0 && !isThere(slots_[at])) at = (at + 1) & (slots_.size() - 1);
  return {at, tag};
}

const SizesAtCorners::Sizes* SizesAtCorners::find(const SurfacePoint& point) const {
  const std::uint32_t number = slots_[search(point).slot].number;
  return number == 0 ? nullptr : &corners_[number - 1].sizes;
}

}  // namespace af2::geometry
