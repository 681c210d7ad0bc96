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
double elementsAround(const SizeSource& point, double growth, double largest) {
  constexpr double kPi = std::numbers::pi;
  const double s = point.size, r = point.radius;
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

FinerInside finerAround(std::span<const SizeSource> points, double growth, double largest) {
  FinerInside finer;
  for (const SizeSource& point : points) {
    finer.around += elementsAround(point, growth, largest);
    finer.shareAtPoints = std::max(finer.shareAtPoints, shareOf(point.size, largest));
  }
  return finer;
}

FinerInside finerInside(const Sizes& sizes) {
  if (sizes.function) return kAnySizes;
  const double largest = largestOf(sizes);
  const auto allowed = [&](double size) { return std::max(size, sizes.minSize); };
  std::vector<SizeSource> points = sizes.sources.points;
  for (SizeSource& point : points) point.size = allowed(point.size);
  FinerInside finer = finerAround(points, sizes.growth, largest);
  const auto add = [&](double size) { finer.share += shareOf(allowed(size), largest); };
  for (const SizeBox& box : sizes.sources.boxes) add(box.size);
  const auto addField = [&](const std::vector<double>& values) {
    if (!values.empty()) add(std::ranges::min(values));
  };
  for (const SizeGrid& grid : sizes.sources.grids) addField(grid.sizes);
  for (const SizeCells& cells : sizes.sources.cells) addField(cells.sizes);
  return finer;
}

}  // namespace af2::geometry
