// Regions to be meshed that no test was written for.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/meshing.h"

namespace af2::testing {

/// An even number of edges of about a length, around a smooth star; as a hole, clockwise.
inline std::vector<Point2> star(std::mt19937& random, Point2 centre, double radius, double size,
                                bool isHole) {
  std::uniform_real_distribution<double> phase(0, 6.28), depth(0, 0.22);
  const double p2 = phase(random), p3 = phase(random), d2 = depth(random), d3 = depth(random);
  const std::size_t count =
      2 * std::max<std::size_t>(3, static_cast<std::size_t>(3.14 * radius / size));
  std::vector<Point2> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
    const double r = radius * (1 + d2 * std::cos(2 * t + p2) + d3 * std::cos(3 * t + p3));
    points.push_back(centre + Point2{r * std::cos(t), r * std::sin(t)});
  }
  if (isHole) std::ranges::reverse(points);
  return points;
}

/// A star-shaped region with 0 to 3 holes and even numbers of edges near the size.
inline FrontInput randomDomain(unsigned seed, double size) {
  std::mt19937 random(seed);
  FrontInput input;
  addLoop(input, star(random, {0, 0}, 1, size, false));
  const std::array<Point2, 3> centres{{{0.28, 0.1}, {-0.25, 0.22}, {-0.05, -0.3}}};
  for (unsigned hole = 0; hole < seed % 4; ++hole)
    addLoop(input, star(random, centres[hole], 0.13, size, true));
  return input;
}

}  // namespace af2::testing
