// Edges as few points, for what is near them.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "geometry/base/box_tree.h"
#include "geometry/occ/edges/edge_samples.h"

namespace af2::geometry {

/// One of a few samples of an edge for each of its segments.
struct Knot {
  Point3 position, tangent;  ///< tangent of length 1, along the edge
  double parameter, size;
  std::size_t piece, first, last;  ///< the samples for which it stands: [first, last)
  bool operator==(const Knot&) const = default;
};

struct KnottedEdge {
  std::vector<Knot> knots;  ///< empty: its sizes are not to be changed
  Box3 box;
  double reach = 0;     ///< how far away the other side of a strip may be
  double blur = 0;      ///< what is nearer is the same place
  double longest = 0;   ///< way from one knot to the next
  bool isBent = false;  ///< it may be both sides of a strip
  bool isStraight = true;

  /// [i] leads from knot i to the next. Null for few knots: to walk along them takes less time than
  /// to build a tree. Built when it is first asked for, by whichever thread.
  const BoxTree* segments() const;
  bool isSameAs(const KnottedEdge& other) const {
    return knots == other.knots && blur == other.blur;
  }

 private:
  friend KnottedEdge knotted(const EdgeSamples& samples, double reachOfSize);
  struct LateTree {
    std::once_flag isBuilt;
    std::optional<BoxTree> tree;
  };
  std::unique_ptr<LateTree> segments_;
};

/// reachOfSize  how far the other side of a strip may be, as a multiple of the size
KnottedEdge knotted(const EdgeSamples& samples, double reachOfSize);

}  // namespace af2::geometry
