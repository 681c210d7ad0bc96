// Wanted sizes that grow gently away from the short segments of a boundary.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/front_input.h"
#include "engine/size_field.h"

namespace af2::geometry {

/// A place that wants a small size, which may grow with the distance from it.
struct SizeSource {
  Point3 position;
  double size = 0;
};

/// The smallest of source.size + growth * distance over all sources.
class GrowingSize {
 public:
  /// largest  sources do not matter where this is wanted or less
  GrowingSize(std::vector<SizeSource> sources, double growth, double largest);
  double at(const Point3& position) const;
  bool isEmpty() const { return sources_.empty(); }

 private:
  struct Cell {
    std::int64_t x, y, z;
    std::uint32_t first, last;  ///< range of sources_
    auto operator<=>(const Cell&) const = default;
  };
  void thin();
  void sortIntoCells();
  std::int64_t cellOf(double coordinate) const;

  std::vector<SizeSource> sources_;
  std::vector<Cell> cells_;
  double growth_, largest_, cellSize_ = 1;
};

/// The corners of a boundary at which it is divided more finely than `wanted` asks for.
std::vector<SizeSource> shortSegments(const FrontInput& boundary, const SizeField& wanted);

/// `wanted`, but near short segments of the boundary no more than what grows from them.
class GradedSize final : public SizeField {
 public:
  GradedSize(const SizeField& wanted, const FrontInput& boundary, double growth);
  double sizeAt(const SurfacePoint& point) const override;

 private:
  const SizeField& wanted_;
  GrowingSize growing_;
};

}  // namespace af2::geometry
