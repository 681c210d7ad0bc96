#include "geometry/sizes/finer_inside.h"

#include <numbers>

#include "engine/base/constants.h"
#include "engine/base/elementary.h"

namespace af2::geometry {
namespace {

/// Of triangles with sides as long as the size, per area, times the square of the size.
constexpr double kDensity = 1 / kUnitTriangle;

/// In a plane through the point: the density integrated over the ball, and from there to where the
/// size is the largest one.
///
/// s, r  the size at the point, and the radius of its ball
double elementsAround(double s, double r, double growth, double largest) {
  constexpr double kPi = std::numbers::pi;
  if (!(s < largest)) return 0;
  const double inside = kPi * r * r / (s * s);
  const double alongRim = 2 * kPi * r / growth * (1 / s - 1 / largest);
  const double beyond = 2 * kPi / (growth * growth) * (logarithm(largest / s) + s / largest - 1);
  return kDensity * (inside + alongRim + beyond);
}

/// How many times as many elements there are with a size as with the largest one.
double shareOf(double size, double largest) {
  return size < largest ? largest / size * (largest / size) : 0;
}

}  // namespace

FinerInside finerAround(std::span<const SizeSource> points, double growth, double largest,
                        double least) {
  FinerInside finer;
  for (const SizeSource& point : points) {
    const double size = std::max(point.size, least);
    finer.around += elementsAround(size, point.radius, growth, largest);
    finer.shareAtPoints = std::max(finer.shareAtPoints, shareOf(size, largest));
  }
  return finer;
}

FinerInside finerInside(const Sizes& sizes) {
  if (sizes.function) return kAnySizes;
  const double largest = largestOf(sizes);
  FinerInside finer = finerAround(sizes.sources.points, sizes.growth, largest, sizes.minSize);
  const auto add = [&](double size) {
    finer.share += shareOf(std::max(size, sizes.minSize), largest);
  };
  for (const SizeBox& box : sizes.sources.boxes) add(box.size);
  const auto addField = [&](const std::vector<double>& values) {
    if (!values.empty()) add(std::ranges::min(values));
  };
  for (const SizeGrid& grid : sizes.sources.grids) addField(grid.sizes);
  for (const SizeCells& cells : sizes.sources.cells) addField(cells.sizes);
  return finer;
}

}  // namespace af2::geometry
