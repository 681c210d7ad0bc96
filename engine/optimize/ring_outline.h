// The sides of a ring of vertices and of its parts.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/optimize/ring_plans.h"

namespace af2 {

/// A part of one side of the ring, or the cut in one of its directions.
struct Stretch {
  enum class Line { Ring, Cut, CutBackwards };
  Line line = Line::Ring;
  std::size_t begin = 0;  ///< Ring only: the place of its first vertex
  int length = 0;
};

/// The sides of a region, from corner to corner.
class Outline {
 public:
  static constexpr std::size_t kMaxSides = 8;
  void add(const Stretch& side) { sides_[size_++] = side; }
  std::size_t size() const { return size_; }
  const Stretch& operator[](std::size_t i) const { return sides_[i]; }

 private:
  std::array<Stretch, kMaxSides> sides_{};
  std::size_t size_ = 0;
};

using StarLines = std::array<int, Outline::kMaxSides>;

/// The numbers of edges of the lines of a star, by side; none if they are not all positive.
std::optional<StarLines> starLines(const Outline& outline);
bool isGrid(const Outline& outline);

class RingSides {
 public:
  RingSides(std::size_t vertices, const std::vector<std::size_t>& corners)
      : vertices_(vertices), corners_(corners) {}

  std::size_t count() const { return corners_.size(); }
  int lengthOf(std::size_t side) const {
    const std::size_t next = corners_[(side + 1) % count()];
    return static_cast<int>((next + vertices_ - corners_[side] - 1) % vertices_ + 1);
  }
  std::size_t placeAt(std::size_t side, int at) const {
    return (corners_[side] + static_cast<std::size_t>(at)) % vertices_;
  }
  Outline whole() const;
  /// The part of the ring that follows the beginning of the cut, and the part before it.
  std::array<Outline, 2> partsOf(const FillingPlan::Cut& cut) const;

 private:
  Stretch part(std::size_t side, int from, int to) const {
    return {Stretch::Line::Ring, placeAt(side, from), to - from};
  }

  std::size_t vertices_;
  const std::vector<std::size_t>& corners_;
};

}  // namespace af2
