// Sources of sizes in space: points, boxes, and background fields on grids and on cells.
#pragma once

#include <array>
#include <vector>

#include "engine/base/export.h"
#include "geometry/sizes/cell_size.h"
#include "geometry/sizes/graded_size.h"
#include "geometry/sizes/position_size.h"

namespace af2::geometry {

/// A box with one wanted size.
struct SizeBox {
  Point3 low, high;
  double size = 0;
};

/// A background field: sizes at the nodes of a regular grid, linear in each direction between them.
struct SizeGrid {
  Point3 origin;                        ///< the first node
  Point3 spacing;                       ///< > 0 from node to node
  std::array<std::size_t, 3> counts{};  ///< nodes along x, y, z, each >= 1
  std::vector<double> sizes;            ///< x varies fastest, then y
};

/// Sizes grow away from each source, except from cells, outside which the size is that at their
/// nearest point. Where several sources apply, the smallest counts.
struct SizeSources {
  std::vector<SizeSource> points;
  std::vector<SizeBox> boxes;
  std::vector<SizeGrid> grids;
  std::vector<SizeCells> cells = {};

  bool isEmpty() const { return points.empty() && boxes.empty() && grids.empty() && cells.empty(); }
};

/// The smallest size that curvature and narrow places may request: the given one, or a twentieth of
/// the wanted size.
inline double leastForLimits(double size, double given) { return given > 0 ? given : size / 20; }

/// Adds points to the sources, with their sizes raised to at least `least`.
AF2_EXPORT void addSources(std::vector<SizeSource> points, double least, SizeSources& sources);

/// The size by `sources`, growing by `growth` per unit of length away from each; infinite where
/// there is none. The limit also applies within a background field: where the field grows faster,
/// its larger sizes are lowered.
///
/// threads  for preparing it; 0: as many as the caller's TBB arena has
///
/// Throws InputError for an invalid source, e.g. a size that is not positive.
AF2_EXPORT PositionSize sizeFrom(SizeSources sources, double growth, int threads = 1);

}  // namespace af2::geometry
