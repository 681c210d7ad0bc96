// The fast form of a free zone at one match: a convex polygon behind a floating-point filter.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "engine/base/predicates.h"
#include "engine/rule/free_zone.h"
#include "engine/step/compiled_rules.h"

namespace af2 {

/// Gives the same answers as ConvexPolygonZone without allocating. One number for each side says on
/// which side a point clearly lies; exact tests decide the other cases.
class ZonePolygon {
 public:
  /// Returns false if the corners do not run counter-clockwise around a convex region.
  bool make(const FastZone& zone, int level, const Point2* matched);
  /// The polygon of some vertices of a rule, at most eight; `vertices` are the matched and new
  /// ones. Returns false unless it is clearly strictly convex.
  bool makeOf(std::span<const std::int8_t> corners, const Point2* vertices);

  const Box2& boundingBox() const { return box_; }
  bool contains(Point2 point, ZoneBoundary boundary) const;
  bool meets(Point2 from, Point2 to, ZoneBoundary boundary) const;

 private:
  static constexpr std::size_t kSides = AffineBatch::kCapacity;
  using Values = std::array<double, kSides>;

  void drawSides();
  bool isPlainlyConvex() const;
  /// For each side a number that is positive on its left, up to an error below errorAt.
  void evaluateSides(Point2 point, Values& values) const {
    for (std::size_t k = 0; k < kSides; ++k)
      values[k] = normalX_[k] * point.x + normalY_[k] * point.y + constant_[k];
  }
  double errorAt(double largestX, double largestY) const {
    // Small products may have lost bits to underflow.
    return error_ * (largestX + largestY + reach_) + detail::kUnderflowGuard;
  }
  /// Whether a point lies beyond side k, or on its line if touching does not count.
  bool isBeyond(std::size_t k, Point2 point, double value, double error,
                ZoneBoundary boundary) const;
  std::span<const Point2> corners() const { return {corners_.data(), count_}; }

  std::array<Point2, kSides + 1> corners_;  // from count_ on: repetitions of the first
  std::size_t count_ = 0;
  Box2 box_;
  // Side k runs from corner k to corner k + 1. From count_ on sides have length zero, and nothing
  // lies beyond them.
  Values sideX_, sideY_;
  Values normalX_, normalY_, constant_;
  double error_ = 0, reach_ = 0;
};

}  // namespace af2
