// The contents of a picture of a single step, before it is drawn.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "dsl/picture/canvas.h"
#include "dsl/run/explain.h"

namespace af2::dsl::picture {

/// A piece of front and one rule there; positions are in the frame of the base edge.
struct PieceScene {
  using Edge = std::pair<std::size_t, std::size_t>;

  struct Vertex {
    Point2 at, outward;  ///< `outward`: the direction in which there is space for the name
    std::string name;    ///< "p3 = c" if the rule has another name for it
    bool isMatched = false, isNew = false, isCulprit = false;
  };

  std::vector<Point2> at;  ///< by vertex of the piece
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;  ///< of the front
  Edge base;
  std::vector<Edge> pattern;  ///< the edges of the front that the rule matched
  std::vector<Loop> zones, elements;
  std::vector<std::pair<Point2, Point2>> newFront;
  /// Where the rule expects a vertex, and where the vertex is; only if the pattern is not there.
  std::vector<std::pair<Point2, Point2>> deviations;
  std::vector<std::size_t> culprits;  ///< what hit the zone: a vertex, or the two ends of an edge
  std::string reason;                 ///< what came of the rule, in words
  Box2 world;                         ///< the visible area

  bool isInPattern(const Edge& edge) const;
  /// Whether the front has edges that the rule does not match.
  bool hasOtherFront() const;
};

/// rule  title of the rule that is shown; empty: the one that was applied or came farthest
PieceScene sceneOf(const RuleSet& rules, const FrontPiece& piece,
                   const std::vector<std::string>& names, const StepExplanation& explained,
                   const std::string& rule);

}  // namespace af2::dsl::picture
