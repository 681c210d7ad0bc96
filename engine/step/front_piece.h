// A piece of front in the plane, and the piece of a front around one of its edges.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/ids.h"
#include "engine/base/point.h"

namespace af2 {

class Front;
class StepChart;

/// A piece of front in the plane. The unmeshed region lies to the left of each edge.
struct FrontPiece {
  std::vector<Point2> vertices;
  /// Chains of vertices joined by edges; a closed chain repeats its first vertex at the end.
  std::vector<std::vector<std::size_t>> chains;
  /// Vertices without an edge.
  std::vector<std::size_t> isolated;
  std::pair<std::size_t, std::size_t> base;  ///< an edge of a chain
  int level = 1;
  double size = 1;  ///< wanted edge length, in the units of the vertices
  /// Colours of vertices of open chains, which are parts of one loop then. See `FrontLoops`. Other
  /// chains are loops of their own.
  std::vector<std::pair<std::size_t, bool>> colours = {};
};

/// A piece of a front as the chart of a base edge shows it: the edge runs along the x axis from the
/// origin.
struct LocalFront {
  FrontPiece piece;
  std::vector<VertexId> ids;  ///< by vertex of the piece
};

/// The edges of a front that come nearer than `reach` (chart units) to the base edge, the
/// neighbours of the base edge in any case, and the isolated vertices there. What the chart hides
/// is left out.
///
/// size  wanted edge length at the base, in chart units
LocalFront localFront(const Front& front, const StepChart& chart, PlaceId base, double size,
                      double reach);

}  // namespace af2
