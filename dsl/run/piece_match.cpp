#include "dsl/run/piece_match.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace af2::dsl {
namespace {

using PieceEdge = std::pair<std::size_t, std::size_t>;
constexpr std::size_t kNotMatched = std::numeric_limits<std::size_t>::max();

/// The vertices that a pattern most likely means where it does not match.
class LikelyMatch {
 public:
  LikelyMatch(const FrontPiece& piece, const PieceFrame& frame) : piece_(piece), frame_(frame) {
    for (const auto& chain : piece.chains)
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) edges_.push_back({chain[i], chain[i + 1]});
  }

  std::optional<std::vector<std::size_t>> of(const RuleDefinition& rule) const {
    std::vector<std::size_t> matched(rule.vertices.size(), kNotMatched);
    matched[0] = piece_.base.first;
    matched[1] = piece_.base.second;
    while (extend(rule, matched)) {
    }
    for (std::size_t v = 2; v < matched.size(); ++v)
      if (matched[v] == kNotMatched)
        matched[v] = nearestTo(rule.vertices[v].reference.at(piece_.level), matched);
    if (std::ranges::count(matched, kNotMatched) > 0) return std::nullopt;
    return matched;
  }

 private:
  /// Returns whether an edge of the pattern led to another vertex.
  bool extend(const RuleDefinition& rule, std::vector<std::size_t>& matched) const {
    bool isChanged = false;
    for (const PatternEdge& edge : rule.edges) {
      std::size_t &from = matched[static_cast<std::size_t>(edge.from)],
                  &to = matched[static_cast<std::size_t>(edge.to)];
      if (from != kNotMatched && to == kNotMatched)
        isChanged |= assign(
            to, [&](const PieceEdge& e) { return e.first == from; }, &PieceEdge::second);
      else if (to != kNotMatched && from == kNotMatched)
        isChanged |= assign(
            from, [&](const PieceEdge& e) { return e.second == to; }, &PieceEdge::first);
    }
    return isChanged;
  }

  template <class Is>
  bool assign(std::size_t& vertex, Is is, std::size_t PieceEdge::*end) const {
    const auto found = std::ranges::find_if(edges_, is);
    if (found == edges_.end()) return false;
    vertex = *found.*end;
    return true;
  }

  std::size_t nearestTo(Point2 reference, const std::vector<std::size_t>& taken) const {
    std::size_t best = kNotMatched;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < piece_.vertices.size(); ++v) {
      const double here = distance(frame_(piece_.vertices[v]), reference);
      if (here >= least || std::ranges::count(taken, v) > 0) continue;
      least = here;
      best = v;
    }
    return best;
  }

  const FrontPiece& piece_;
  const PieceFrame& frame_;
  std::vector<PieceEdge> edges_;
};

}  // namespace

PieceFrame::PieceFrame(const RuleSet& rules, const FrontPiece& piece)
    : origin_(piece.vertices[piece.base.first]) {
  const Point2 along = piece.vertices[piece.base.second] - origin_;
  const double baseLength = length(along);
  axis_ = (1 / baseLength) * along;
  unit_ = rules.definition().unit == ChartUnit::WantedLength ? piece.size : baseLength;
}

std::optional<PieceMatch> matchInPiece(const RuleSet& rules, const FrontPiece& piece,
                                       const AF2Rule& rule, std::span<const VertexId> matched) {
  const PieceFrame frame(rules, piece);
  PieceMatch match;
  for (const VertexId v : matched) match.matched.push_back(v.value);
  if (matched.empty()) {
    const auto likely = LikelyMatch(piece, frame).of(rule.definition());
    if (!likely) return std::nullopt;
    match.matched = *likely;
  }
  EvalRequest request;
  request.rule = rule.name();
  request.level = piece.level;
  for (std::size_t v = 0; v < match.matched.size(); ++v)
    request.match[rule.definition().vertices[v].name] = frame(piece.vertices[match.matched[v]]);
  match.evaluated = evaluateRule(rules, request);
  return match;
}

}  // namespace af2::dsl
