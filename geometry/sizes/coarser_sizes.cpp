#include "geometry/sizes/coarser_sizes.h"

#include <algorithm>
#include <utility>

namespace af2::geometry {
namespace {

void scale(SizeSources& sources, double factor) {
  for (SizeSource& point : sources.points) point.size *= factor;
  for (SizeBox& box : sources.boxes) box.size *= factor;
  for (SizeGrid& grid : sources.grids)
    for (double& size : grid.sizes) size *= factor;
  for (SizeCells& cells : sources.cells)
    for (double& size : cells.sizes) size *= factor;
}

void scale(ChordBounds& chords, double factor) {
  const auto each = [&](ChordBound& bound) {
    bound.value *= bound.isShareOfSize ? factor : factor * factor;
  };
  each(chords.everywhere);
  for (auto& [face, bound] : chords.faces) each(bound);
  for (auto& [name, bound] : chords.parts) each(bound);
}

}  // namespace

Sizes timesAsLarge(Sizes sizes, double factor) {
  constexpr double kFewestPerTurn = 3;
  for (double* size : {&sizes.size, &sizes.minSize, &sizes.maxSize}) *size *= factor;
  for (auto* ofIds : {&sizes.faceSizes, &sizes.edgeSizes})
    for (auto& [id, size] : *ofIds) size *= factor;
  for (auto* ofNames : {&sizes.partSizes, &sizes.edgeNames})
    for (auto& [name, size] : *ofNames) size *= factor;
  scale(sizes.sources, factor);
  scale(sizes.chords, factor);
  if (sizes.function)
    sizes.function = PositionSize([function = std::move(sizes.function), factor](
                                      std::span<const Point3> at, std::span<double> values) {
      function.at(at, values);
      for (double& value : values) value *= factor;
    });
  if (sizes.elementsPerTurn > 0)
    sizes.elementsPerTurn = std::max(kFewestPerTurn, sizes.elementsPerTurn / factor);
  sizes.elementsAcross /= factor;
  return sizes;
}

}  // namespace af2::geometry
