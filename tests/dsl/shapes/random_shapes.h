// Random shapes for tests: in general position, and on a lattice where everything touches.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "dsl/shapes/shape.h"

namespace af2::dsl::test {

/// The seed of this run; set AF2_TEST_SEED to repeat one.
inline std::uint32_t seedOfRun() {
  const char* given = std::getenv("AF2_TEST_SEED");
  return given ? static_cast<std::uint32_t>(std::stoul(given)) : 20240229u;
}

inline std::string seedNote() { return "AF2_TEST_SEED=" + std::to_string(seedOfRun()); }

class RandomShapes {
 public:
  explicit RandomShapes(std::uint32_t seed) : generator_(seed) {}

  int integer(int low, int high) { return low + static_cast<int>(generator_() % (high - low + 1)); }
  double real(double low, double high) {
    return low + (high - low) * (static_cast<double>(generator_()) / 4294967296.0);
  }

  Point2 point() { return {real(-2, 2), real(-2, 2)}; }
  Point2 latticePoint() {
    return {static_cast<double>(integer(-7, 7)), static_cast<double>(integer(-7, 7))};
  }

  /// In general position.
  Shape shape(int depth) {
    if (depth > 0) return combined(shape(depth - 1), shape(depth - 1));
    switch (integer(0, 5)) {
      case 0:
        return Shape::disc(point(), real(0.1, 1.5));
      case 1:
        return Shape::sector(point(), real(0.3, 2), real(-3, 3), real(3, 9));
      case 2:
        return Shape::hull({point(), point(), point(), point(), point()});
      case 3:
        return Shape::left(point(), point());
      case 4:
        return star();
      default:
        return Shape::grow(Shape::hull({point(), point(), point()}), real(0.05, 0.5));
    }
  }

  /// With whole coordinates; circles of radius 5 about the origin and its like pass through many
  /// lattice points.
  Shape latticeShape(int depth) {
    if (depth > 0) return combined(latticeShape(depth - 1), latticeShape(depth - 1));
    const Point2 p = latticePoint();
    switch (integer(0, 5)) {
      case 0:
        return Shape::disc({static_cast<double>(integer(-3, 3)), 0}, 5);
      case 1:
        return Shape::disc(p, integer(1, 4));
      case 2:
        return Shape::hull({p, p + Point2{3, 0}, p + Point2{3, 2}, p + Point2{0, 2}});
      case 3:
        return Shape::left(p, kDirections[integer(0, 7)]);
      case 4:
        return Shape::sector(p, 5, 1.5707963267948966 * integer(0, 3), 6.2);
      default:
        return cap(p);
    }
  }

 private:
  static constexpr Point2 kDirections[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1},
                                           {1, 1}, {3, 4}, {-1, 1}, {-4, 3}};

  Shape combined(Shape first, Shape second) {
    switch (integer(0, 2)) {
      case 0:
        return std::move(first) | std::move(second);
      case 1:
        return std::move(first) & std::move(second);
      default:
        return std::move(first) - std::move(second);
    }
  }

  /// Not convex, with arcs between its tips on every other side.
  Shape star() {
    const Point2 centre = point();
    std::vector<PathStep> path;
    constexpr Point2 kTips[] = {{1, 0},  {0.4, 0.4},   {0, 1},  {-0.4, 0.4},
                                {-1, 0}, {-0.4, -0.4}, {0, -1}, {0.4, -0.4}};
    const double size = real(0.5, 1.5);
    for (int i = 0; i < 8; ++i) {
      const Point2 to = centre + size * kTips[i], from = centre + size * kTips[(i + 7) % 8];
      const Point2 aside = 0.1 * Point2{to.y - from.y, from.x - to.x};
      PathStep step{to, {}};
      if (i % 3 == 0) step.via = 0.5 * (from + to) + (i % 2 ? 1.0 : -1.0) * aside;
      path.push_back(step);
    }
    return Shape::poly(path);
  }

  /// A half disc of radius 5 or what is left of a rectangle without one.
  Shape cap(Point2 p) {
    const Point2 low = p + Point2{-5, 0}, high = p + Point2{5, 0};
    if (integer(0, 1)) return Shape::poly({{high, {}}, {low, p + Point2{3, 4}}});
    return Shape::poly({{high, p + Point2{-3, 4}},
                        {high + Point2{0, 6}, {}},
                        {low + Point2{0, 6}, {}},
                        {low, {}}}) |
           Shape::disc(p, 1);
  }

  std::mt19937 generator_;
};

}  // namespace af2::dsl::test
