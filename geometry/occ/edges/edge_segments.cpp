#include "geometry/occ/edges/edge_segments.h"

#include <algorithm>

#include "geometry/edges/curve_division.h"
#include "geometry/occ/sizes/sizing.h"

namespace af2::geometry {

namespace {

/// A smooth piece of an edge, to be divided into equal shares.
struct SharedPiece {
  std::vector<double> count;  ///< segmentsAlong
  std::size_t segments = 1, fewest = 1;

  SharedPiece(const EdgePiece& piece, const CadSizes& sizes)
      : count(segmentsAlong(piece.arcLength, piece.sizes)) {
    double byTurn = turnAlong(piece.positions) / sizes.edgeTurn;
    if (byTurn > 0.01 && sizes.chords.areGiven()) byTurn = count.back();  // none is too long
    const bool isAsked = sizes.elementsPerTurn > 0 || sizes.chords.areGiven();
    segments = wholeSegments(count.back(), isAsked ? byTurn : 0, sizes.curvedShare);
    fewest = std::min(segments, fewestSegments(count.back(), byTurn, sizes.curvedShare));
  }

  /// Of one segment, in wanted sizes, if there are so many.
  double load(std::size_t ofSegments) const {
    return count.back() / static_cast<double>(ofSegments);
  }
};

void addSegment(std::vector<SharedPiece>& pieces) {
  std::size_t coarsest = 0;
  const auto load = [&](std::size_t i) { return pieces[i].load(pieces[i].segments); };
  for (std::size_t i = 1; i < pieces.size(); ++i)
    if (load(i) > load(coarsest)) coarsest = i;
  ++pieces[coarsest].segments;
}

/// Where segments grow least by it, if there may be one fewer anywhere.
void dropSegment(std::vector<SharedPiece>& pieces) {
  SharedPiece* best = nullptr;
  for (SharedPiece& piece : pieces) {
    if (piece.segments <= piece.fewest) continue;
    if (!best || piece.load(piece.segments - 1) < best->load(best->segments - 1)) best = &piece;
  }
  if (best) --best->segments;
}

/// Appends the ends of `segments` equal shares of the count, without the start of the piece.
void place(const EdgePiece& piece, const std::vector<double>& count, std::size_t segments,
           std::vector<double>& parameters) {
  for (const CurvePlace& at : equalShares(count, segments))
    parameters.push_back(at.between<double>(piece.parameters));
  parameters.push_back(piece.parameters.back());
}

}  // namespace

std::vector<double> divide(const EdgeSamples& samples, AskedSegments asked, const CadSizes& sizes) {
  std::vector<SharedPiece> pieces;
  std::size_t total = 0;
  for (const EdgePiece& piece : samples.pieces) total += pieces.emplace_back(piece, sizes).segments;
  for (; total < asked.least; ++total) addSegment(pieces);
  for (int i = 0; i < asked.change; ++i) addSegment(pieces);
  if (asked.change < 0 && total > asked.least) dropSegment(pieces);
  std::vector<double> parameters{samples.pieces.front().parameters.front()};
  for (std::size_t i = 0; i < samples.pieces.size(); ++i)
    place(samples.pieces[i], pieces[i].count, pieces[i].segments, parameters);
  return parameters;
}

double wantedSegments(const EdgeSamples& samples) {
  double wanted = 0;
  for (const EdgePiece& piece : samples.pieces)
    wanted += segmentsAlong(piece.arcLength, piece.sizes).back();
  return wanted;
}

std::size_t fewestSegmentsOf(const EdgeSamples& samples, const CadSizes& sizes) {
  std::size_t fewest = 0;
  for (const EdgePiece& piece : samples.pieces) fewest += SharedPiece(piece, sizes).fewest;
  return fewest;
}

}  // namespace af2::geometry
