// The cells between the samples of an edge, and how fine they are to be.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/occ/edges/edge_samples.h"

namespace af2::geometry {

/// The cells of an interval in which a curve is smooth.
struct IntervalCells {
  std::vector<double> parameters;  ///< of their ends
  double step = 0;                 ///< of the parameter, if it is the same for all
};
using Cells = std::vector<IntervalCells>;

/// Of an interval, however short it is.
constexpr int kMinCells = 16;

double countOf(const Cells& cells);

/// About `total` cells, of equal lengths within an interval.
///
/// breaks  ends of the intervals
Cells equalCells(const std::vector<double>& breaks, double total);

/// How many times too long the worst cell between samples is. Sizes that were asked for may be far
/// below the largest, and small in a few places only: samples are to be dense there as well.
double coarseness(const std::vector<EdgePiece>& pieces);

/// Into how many cells one is to be divided.
double partsFor(double coarseness);

/// Divides the cells that are too long for the sizes at their samples.
///
/// pieces  the samples at the ends of the cells
Cells finer(const Cells& cells, const std::vector<EdgePiece>& pieces);

}  // namespace af2::geometry
