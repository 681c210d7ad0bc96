#include "geometry/occ/edges/edge_chains.h"

#include <algorithm>

#include "geometry/occ/base/points.h"

namespace af2::geometry {

namespace {

/// The same piece, from its other end.
EdgePiece turnedRound(EdgePiece piece) {
  const double length = piece.arcLength.back();
  for (double& along : piece.arcLength.edit()) along = length - along;
  std::ranges::reverse(piece.parameters.edit());
  std::ranges::reverse(piece.arcLength.edit());
  std::ranges::reverse(piece.positions.edit());
  std::ranges::reverse(piece.sizes);
  std::ranges::reverse(piece.least.edit());
  return piece;
}

/// Continues a piece with the next one, which begins where it ends.
void append(const EdgePiece& next, EdgePiece& piece) {
  const double start = piece.arcLength.back();
  piece.sizes.back() = std::min(piece.sizes.back(), next.sizes.front());
  std::vector<double>& least = piece.least.edit();
  least.back() = std::min(least.back(), next.least.front());
  const auto add = [](const auto& from, auto& to) {
    to.insert(to.end(), from.begin() + 1, from.end());
  };
  add(next.parameters, piece.parameters.edit());
  add(next.positions, piece.positions.edit());
  add(next.sizes, piece.sizes);
  add(next.least, least);
  for (std::size_t i = 1; i < next.arcLength.size(); ++i)
    piece.arcLength.edit().push_back(start + next.arcLength[i]);
}

}  // namespace

ChainCurve::ChainCurve(const ModelShape& model, const EdgeChain& chain) {
  double start = 0;
  for (const ChainLink& link : chain.links) {
    parts_.push_back({BRepAdaptor_Curve(model.edge(link.edge)), link.isReversed, start});
    start += parts_.back().curve.LastParameter() - parts_.back().curve.FirstParameter();
  }
}

Point3 ChainCurve::at(double parameter) const {
  auto part = parts_.begin();
  while (part + 1 != parts_.end() && (part + 1)->start <= parameter) ++part;
  const double within = parameter - part->start;
  const BRepAdaptor_Curve& curve = part->curve;
  return toPoint(curve.Value(part->isReversed ? curve.LastParameter() - within
                                              : curve.FirstParameter() + within));
}

double ChainCurve::parameterOf(std::size_t link, double ofEdge) const {
  const Part& part = parts_[link];
  return part.start + (part.isReversed ? part.curve.LastParameter() - ofEdge
                                       : ofEdge - part.curve.FirstParameter());
}

EdgePart chainPart(const EdgeChain& chain, EdgeSamples samples, const std::vector<Ends>& ends) {
  const auto pointAt = [&](const ChainLink& link, bool atStart) {
    const Ends& own = ends[static_cast<std::size_t>(link.edge) - 1];
    return atStart != link.isReversed ? own.first : own.last;
  };
  EdgePart part{static_cast<std::size_t>(chain.id()) - 1, std::move(samples), {}};
  part.ends = {pointAt(chain.links.front(), true), pointAt(chain.links.back(), false)};
  part.isChain = true;
  return part;
}

PointAt curveOf(const ModelShape& model, const EdgePart& part, const MergedEdges& merged) {
  const int id = static_cast<int>(part.edge) + 1;
  if (!part.isChain)
    return
        [curve = BRepAdaptor_Curve(model.edge(id))](double t) { return toPoint(curve.Value(t)); };
  const auto chain = std::ranges::find(merged.chains, id, &EdgeChain::id);
  return [curve = ChainCurve(model, *chain)](double t) { return curve.at(t); };
}

EdgeSamples chainedSamples(const ModelShape& model, const EdgeChain& chain,
                           const std::vector<EdgeSamples>& samples) {
  const ChainCurve curve(model, chain);
  EdgeSamples chained;
  for (std::size_t i = 0; i < chain.links.size(); ++i) {
    const auto [edge, isReversed] = chain.links[i];
    const EdgeSamples& own = samples[static_cast<std::size_t>(edge) - 1];
    chained.length += own.length;
    chained.wanted = i == 0 ? own.wanted : std::min(chained.wanted, own.wanted);
    if (chained.problem.empty()) chained.problem = own.problem;
    std::vector<EdgePiece> pieces = own.pieces;
    if (isReversed) std::ranges::reverse(pieces);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      EdgePiece piece = isReversed ? turnedRound(std::move(pieces[k])) : std::move(pieces[k]);
      for (double& parameter : piece.parameters.edit()) parameter = curve.parameterOf(i, parameter);
      if (k == 0 && !chained.pieces.empty())
        append(piece, chained.pieces.back());
      else
        chained.pieces.push_back(std::move(piece));
    }
  }
  if (chained.pieces.empty()) return chained;
  chained.start = chained.pieces.front().positions.front();
  chained.end = chained.pieces.back().positions.back();
  return chained;
}

}  // namespace af2::geometry
