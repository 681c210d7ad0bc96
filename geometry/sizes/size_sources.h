// Places in space that want sizes of their own: points, boxes and background fields.
#pragma once

#include <array>
#include <vector>

#include "engine/base/export.h"
#include "geometry/sizes/graded_size.h"
#include "geometry/sizes/position_size.h"

namespace af2::geometry {

/// A box that wants one size in all of it.
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

/// Away from each of them sizes may grow; where several reach, the smallest counts.
struct SizeSources {
  std::vector<SizeSource> points;
  std::vector<SizeBox> boxes;
  std::vector<SizeGrid> grids;

  bool isEmpty() const { return points.empty() && boxes.empty() && grids.empty(); }
};

/// The smallest size that curvature and narrow places may ask for: what is given, or a twentieth of
/// the wanted size.
inline double leastForLimits(double size, double given) { return given > 0 ? given : size / 20; }

/// Adds points to sources, none of which wants less than `least`.
AF2_EXPORT void addSources(std::vector<SizeSource> points, double least, SizeSources& sources);

/// The size that `sources` want, growing by `growth` per unit of length away from each; infinite
/// where there is none. Also within a background field it grows no faster: where the field does,
/// its larger sizes are lowered.
///
/// Throws InputError for a source that makes no sense, e.g. a size that is not positive.
AF2_EXPORT PositionSize sizeFrom(SizeSources sources, double growth);

}  // namespace af2::geometry
