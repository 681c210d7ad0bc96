// The edges of a model after their division, which the faces on both sides share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/point.h"
#include "geometry/edges/segment_count.h"

namespace af2::geometry {

struct DividedEdge {
  /// Along the curve, ends included; empty: the edge has no length (a pole, a point) or is
  /// unusable.
  std::vector<double> parameters;
  std::vector<std::uint32_t> points;  ///< by parameter: index into DividedEdges::points
  /// Indices of the parameters, between the ends, at which another edge ends on this one.
  std::vector<std::size_t> stops;
  std::string problem;                 ///< why it is unusable; its faces fail
  double wanted = 0;                   ///< the requested size, before all limits
  int twin = 0;                        ///< the edge whose vertices it uses; 0: none
  std::optional<std::uint32_t> point;  ///< the point to which the edge was collapsed on request
  /// Of its parts between the stops: indices in DividedEdges::counts. Parts with the same vertices
  /// have the same count.
  std::vector<std::size_t> counts = {};
};

/// Edges that are collapsed to points, by id, with the largest distance of vertices that are
/// merged.
using CollapsedEdges = std::map<int, double>;

struct DividedEdges {
  std::vector<Point3> points;      ///< vertices of the model first, then along the edges
  std::vector<DividedEdge> edges;  ///< [0] is edge 1
  /// The numbers of segments that can be changed one by one. Their indices do not depend on
  /// changes.
  std::vector<SegmentCount> counts = {};

  std::size_t segmentCount() const;
};

/// What changed from one division of the same edges to the next.
struct DivisionChange {
  std::vector<bool> isChanged;  ///< by edge; [0] is edge 1
  std::vector<std::uint32_t>
      newIndex;  ///< by point of the old division; only for edges that stayed
};

DivisionChange compare(const DividedEdges& before, const DividedEdges& after);

}  // namespace af2::geometry
