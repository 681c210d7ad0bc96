#include "geometry/occ/edges/knotted_edges.h"

#include <algorithm>

#include "geometry/base/constants.h"

namespace af2::geometry {
namespace {

std::size_t knotsAlong(const EdgePiece& piece) {
  constexpr double kKnotsPerSegment = 3;
  constexpr std::size_t kFewest = 4;
  const std::size_t cells = piece.positions.size() - 1;
  double segments = 0;
  for (std::size_t i = 1; i <= cells; ++i)
    segments +=
        2 * (piece.arcLength[i] - piece.arcLength[i - 1]) / (piece.sizes[i - 1] + piece.sizes[i]);
  const double knots = std::min(kKnotsPerSegment * segments, static_cast<double>(cells));
  return std::min(std::max(kFewest, static_cast<std::size_t>(knots)), cells);
}

void addPiece(const EdgePiece& piece, std::size_t index, KnottedEdge& edge) {
  const std::size_t cells = piece.positions.size() - 1, count = knotsAlong(piece);
  const auto sampleAt = [&](std::size_t knot) { return knot * cells / count; };
  if (index == 0) edge.knots.reserve(count + 1);
  for (std::size_t k = 0; k <= count; ++k) {
    const std::size_t here = sampleAt(k);
    const std::size_t before = sampleAt(k > 0 ? k - 1 : 0),
                      after = sampleAt(std::min(k + 1, count));
    const Point3 along = piece.positions[after] - piece.positions[before];
    const double chord = length(along);
    if (!(chord > 0)) continue;
    edge.knots.push_back({piece.positions[here], (1 / chord) * along, piece.parameters[here],
                          piece.sizes[here], index, (before + here + 1) / 2,
                          (here + after) / 2 + 1});
  }
}

std::vector<Box3> boxesBetween(const std::vector<Knot>& knots) {
  std::vector<Box3> boxes(knots.empty() ? 0 : knots.size() - 1);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    boxes[i].add(knots[i].position);
    boxes[i].add(knots[i + 1].position);
  }
  return boxes;
}

}  // namespace

const BoxTree* KnottedEdge::segments() const {
  if (!segments_) return nullptr;
  std::call_once(segments_->isBuilt, [&] { segments_->tree.emplace(boxesBetween(knots)); });
  return &*segments_->tree;
}

KnottedEdge knotted(const EdgeSamples& samples, double reachOfSize) {
  constexpr double kHalfTurn = 3, kNoTurn = 0.1;
  constexpr std::size_t kMany = 200;
  KnottedEdge edge;
  for (std::size_t i = 0; i < samples.pieces.size(); ++i) addPiece(samples.pieces[i], i, edge);
  double turn = 0;
  for (std::size_t i = 0; i < edge.knots.size(); ++i) {
    const Knot& knot = edge.knots[i];
    edge.box.add(knot.position);
    edge.reach = std::max(edge.reach, reachOfSize * knot.size);
    if (i == 0) continue;
    turn += distance(knot.tangent, edge.knots[i - 1].tangent);
    edge.longest = std::max(edge.longest, distance(knot.position, edge.knots[i - 1].position));
  }
  if (edge.knots.size() > kMany) edge.segments_ = std::make_unique<KnottedEdge::LateTree>();
  edge.blur = kUnseen * samples.wanted;
  edge.isBent = turn > kHalfTurn;
  edge.isStraight = turn < kNoTurn;
  return edge;
}

}  // namespace af2::geometry
