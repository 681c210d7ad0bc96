// A plane face with one loop, for tests of the ways to fill it.
#pragma once

#include <vector>

#include "geometry/charts/flat_surface.h"
#include "geometry/fill/fill_way.h"
#include "tests/support/meshing.h"

namespace af2::testing {

struct FlatFace {
  /// loop  counter-clockwise, one segment from each point to the next
  explicit FlatFace(const std::vector<Point2>& loop, double wanted = 0.5) : size(wanted) {
    addLoop(boundary.input, loop);
    options.optimize = false;
    makeTools = [this](geometry::ChartKind kind) {
      return PieceTools{surface.makeCharts(kind), {&size, [](const SizeField*) {}}};
    };
  }
  FlatFace(const FlatFace&) = delete;
  FlatFace& operator=(const FlatFace&) = delete;

  geometry::FaceTask task() const {
    return {surface, boundary, size, area, 1, algorithm, options, {}, limits, progress, makeTools};
  }

  geometry::FlatSurface surface{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  geometry::FaceBoundary boundary;
  UniformSize size;
  double area = 0;
  AF2Algorithm algorithm{triangleSet()};
  geometry::FillOptions options;
  geometry::TryLimits limits;
  ProgressCallback progress;
  std::function<PieceTools(geometry::ChartKind)> makeTools;
};

/// A square of side 4 in segments of half a unit.
inline std::vector<Point2> squareLoop() { return divided({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 0.5); }
/// It crosses itself, and still has an area to its left: a notch reaches through the other side.
inline std::vector<Point2> crossedLoop() { return {{0, 0}, {6, 0}, {6, 4}, {3, -1}, {0, 4}}; }
/// A twentieth as wide as its segments are long.
inline std::vector<Point2> stripLoop() {
  return {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 0.05}, {2, 0.05}, {1, 0.05}, {0, 0.05}};
}

}  // namespace af2::testing
