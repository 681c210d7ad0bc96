// The lines that go up from the corners of a boundary through the corners of layers.
// Not installed.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "geometry/layers/layer_runs.h"
#include "geometry/layers/surface_walk.h"

namespace af2::geometry {

/// The corners of the layers above one corner of the boundary.
struct LayerColumn {
  std::size_t loop = 0, corner = 0;
  std::vector<SurfacePoint> points;    ///< [0] on the boundary, [k] on top of layer k
  std::size_t levels = 0;              ///< layers that it has, less than the number of points
  double share = 1;                    ///< of the heights asked for, from kThinnest to 1
  Point3 direction = {};               ///< unit vector along which it leaves the boundary
  std::vector<double> distances = {};  ///< of points [1], [2], ... along it, if `share` is 1
  /// Not empty: the layers end here, on the boundary, and these are its corners at the points.
  std::vector<std::size_t> corners = {};
  int fan = -1;  ///< columns above the same corner have the same number, >= 0
};

/// The layers between two columns, above a segment of the boundary or within a fan.
struct LayerCell {
  std::size_t left = 0, right = 0;  ///< columns, in the direction of the loop
};

/// The columns of a run, in the direction of the loop.
struct RunColumns {
  LayerRun run;
  std::size_t first = 0, count = 0;  ///< columns
};

/// The layers of a face.
struct LayerGrid {
  std::vector<LayerColumn> columns;
  std::vector<LayerCell> cells;
  std::vector<RunColumns> runs;
};

/// Places the points of a column that does not end on the boundary. It gets fewer levels where the
/// surface cannot be reached any more.
void placePoints(LayerColumn& column, const SurfaceWalk& walk);

/// Places the columns, as if there was room for all of them. At a convex corner there is one, in
/// the middle, and those beside it lean away from the corner, so that they share the room. Around a
/// reflex corner of more than 240 degrees there is a fan of columns. At their ends, layers end on
/// the boundary, if it has vertices at their heights there, or become fewer, one by one.
///
/// edges    of the segments of the boundary
/// blocked  vertices above which there are to be no layers
LayerGrid layerGrid(const FaceBoundary& boundary, const EdgeLayers& layers,
                    const std::vector<std::vector<int>>& edges, const std::set<VertexId>& blocked,
                    const SurfaceWalk& walk);

}  // namespace af2::geometry
