#include "geometry/occ/edges/edge_cells.h"

#include <algorithm>
#include <cmath>

namespace af2::geometry {

namespace {

/// How many times too long a cell is, which ends at sample i.
double coarsenessAt(const EdgePiece& piece, std::size_t i) {
  constexpr double kMaxOfCell = 0.25;  // length of a cell
  return (piece.arcLength[i] - piece.arcLength[i - 1]) / piece.sizes[i] / kMaxOfCell;
}

}  // namespace

double countOf(const Cells& cells) {
  double count = 0;
  for (const IntervalCells& interval : cells)
    count += static_cast<double>(interval.parameters.size());
  return count;
}

Cells equalCells(const std::vector<double>& breaks, double total) {
  const std::size_t intervals = breaks.size() - 1;
  const int count = std::max(kMinCells, static_cast<int>(total / static_cast<double>(intervals)));
  Cells cells(intervals);
  for (std::size_t i = 0; i < intervals; ++i) {
    cells[i].step = (breaks[i + 1] - breaks[i]) / count;
    cells[i].parameters.reserve(static_cast<std::size_t>(count) + 1);
    for (int k = 0; k < count; ++k) cells[i].parameters.push_back(breaks[i] + k * cells[i].step);
    cells[i].parameters.push_back(breaks[i + 1]);
  }
  return cells;
}

double coarseness(const std::vector<EdgePiece>& pieces) {
  double worst = 0;
  for (const EdgePiece& piece : pieces)
    for (std::size_t i = 1; i < piece.sizes.size(); ++i)
      worst = std::max(worst, coarsenessAt(piece, i));
  return worst;
}

double partsFor(double coarseness) {
  constexpr double kMargin = 1.25, kMaxAtOnce = 16;
  return std::min(kMargin * coarseness, kMaxAtOnce);
}

Cells finer(const Cells& cells, const std::vector<EdgePiece>& pieces) {
  Cells result;
  std::size_t piece = 0, sample = 0;
  for (const IntervalCells& divided : cells) {
    const std::vector<double>& interval = divided.parameters;
    std::vector<double>& parameters = result.emplace_back().parameters;
    parameters.push_back(interval.front());
    if (sample + 1 == pieces[piece].parameters.size()) {
      ++piece;
      sample = 0;
    }
    for (std::size_t i = 1; i < interval.size(); ++i) {
      const double coarseness = coarsenessAt(pieces[piece], ++sample);
      const double parts = coarseness > 1 ? std::ceil(partsFor(coarseness)) : 1;
      for (double k = 1; k < parts; ++k)
        parameters.push_back(interval[i - 1] + k / parts * (interval[i] - interval[i - 1]));
      parameters.push_back(interval[i]);
    }
  }
  return result;
}

}  // namespace af2::geometry
