// Sizes that are known at the corners of a boundary.
// Not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/front_input.h"

namespace af2::geometry {

/// A table of sizes by the corners of a boundary. A mesher asks for the size at a corner many
/// times, and each answer would take an evaluation of the surface and of all sizes by position.
class SizesAtCorners {
 public:
  struct Sizes {
    double wanted = 0, graded = 0;
  };

  explicit SizesAtCorners(const FrontInput& boundary);

  std::size_t count() const { return corners_.size(); }
  const SurfacePoint& corner(std::size_t i) const { return corners_[i].point; }
  Sizes& at(std::size_t i) { return corners_[i].sizes; }
  /// Null where there is no corner with exactly this place, normal and parameters.
  const Sizes* find(const SurfacePoint& point) const;

 private:
  struct Corner {
    SurfacePoint point;
    Sizes sizes;
  };

  /// Part of what a place is mixed to stands here, so that nearly all places that are no corners
  /// are told apart without a look at a corner.
  struct Slot {
    std::uint32_t number = 0;  ///< 0: empty; else 1 + the index of a corner
    std::uint32_t tag = 0;
  };
  struct Found {
    std::size_t slot;  ///< that of the corner, or the empty one where it would be
    std::uint32_t tag;
  };

  Found search(const SurfacePoint& point) const;

  std::vector<Corner> corners_;  ///< each once
  std::vector<Slot> slots_;
};

}  // namespace af2::geometry
