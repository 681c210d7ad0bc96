// Finds the runs of segments of a boundary along which a face gets the same layers, and how they
// end. Not installed.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/edges/divided_edges.h"
#include "geometry/layers/layer_heights.h"
#include "geometry/mesh/face_boundary.h"

namespace af2::geometry {

/// Consecutive segments of a loop with equal layers.
struct LayerRun {
  std::size_t loop = 0;
  std::size_t first = 0;     ///< corner at which it begins
  std::size_t segments = 0;  ///< the corner at which it ends is that many corners further on
  bool isClosed = false;     ///< it is the whole loop
  LayerHeights heights;
};

/// A loop of a boundary, with corners counted on from its end.
class LoopView {
 public:
  explicit LoopView(const std::vector<BoundaryCorner>& loop) : loop_(loop) {}

  std::size_t size() const { return loop_.size(); }
  const BoundaryCorner& at(std::size_t corner) const { return loop_[corner % loop_.size()]; }
  std::size_t before(std::size_t corner) const {
    return (corner + loop_.size() - 1) % loop_.size();
  }
  /// Unit vectors in the tangent plane of a corner, along the segments that end and begin there.
  Point3 directionIn(std::size_t corner) const { return direction(before(corner), corner, corner); }
  Point3 directionOut(std::size_t corner) const { return direction(corner, corner + 1, corner); }
  /// The angle by which the loop turns to the left at a corner, from -pi to pi; -pi at the tip of
  /// a line inside the face.
  double turnAt(std::size_t corner) const;
  double lengthOf(std::size_t segment) const {
    return distance(at(segment).point.position, at(segment + 1).point.position);
  }

 private:
  Point3 direction(std::size_t from, std::size_t to, std::size_t in) const;

  const std::vector<BoundaryCorner>& loop_;
};

/// By loop and segment, from corner i to the next: the divided edge of which it is a part; 0: none.
std::vector<std::vector<int>> edgesOfSegments(const FaceBoundary& boundary,
                                              const DividedEdges& divided);

/// In the order of the loops. Runs end where the layers become other ones, and at corners without a
/// normal.
std::vector<LayerRun> layerRuns(const FaceBoundary& boundary, const EdgeLayers& layers,
                                const std::vector<std::vector<int>>& edges);

/// Whether layers that end at a corner may end on the boundary that goes on from there, rather than
/// become fewer before they reach it.
///
/// turn  by which the boundary turns there, as LoopView::turnAt gives it
bool mayEndOnBoundary(double turn);

}  // namespace af2::geometry
