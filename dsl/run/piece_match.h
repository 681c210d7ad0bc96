// A rule at a match in a piece of front: where its vertices lie, its zone, and what the rule says.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dsl/run/evaluate.h"
#include "engine/base/export.h"
#include "engine/base/ids.h"
#include "engine/step/front_piece.h"

namespace af2::dsl {

/// Maps a piece of front to the frame of its base edge, in which rules are written.
class AF2_EXPORT PieceFrame {
 public:
  PieceFrame(const RuleSet& rules, const FrontPiece& piece);

  Point2 operator()(Point2 p) const {
    const Point2 d = p - origin_;
    return {dot(axis_, d) / unit_, cross(axis_, d) / unit_};
  }

 private:
  Point2 origin_, axis_;
  double unit_ = 1;
};

struct PieceMatch {
  std::vector<std::size_t> matched;  ///< vertices of the piece, in pattern order
  EvalResult evaluated;              ///< in the frame of the base edge
};

/// A rule at the vertices that it matched, or, where these are empty, at those that its pattern
/// most likely means: neighbours along the front, and else the vertices nearest to the references.
/// Nothing if the piece has fewer vertices than the pattern.
AF2_EXPORT std::optional<PieceMatch> matchInPiece(const RuleSet& rules, const FrontPiece& piece,
                                                  const AF2Rule& rule,
                                                  std::span<const VertexId> matched);

}  // namespace af2::dsl
