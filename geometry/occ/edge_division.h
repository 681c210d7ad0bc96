// Divides each edge of a model once, so that the faces on both sides share its vertices.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "geometry/occ/mesh_model.h"
#include "geometry/occ/model_shape.h"

namespace af2::geometry {

struct DividedEdge {
  /// Along the curve, ends included; empty: the edge has no length (a pole, a point) or is
  /// unusable.
  std::vector<double> parameters;
  std::vector<std::uint32_t> points;  ///< by parameter: index into DividedEdges::points
  /// Indices of those, between the ends, at which another edge ends on this one.
  std::vector<std::size_t> stops;
  std::string problem;                 ///< why it is unusable; its faces fail
  double wanted = 0;                   ///< the size asked for, before all limits
  int twin = 0;                        ///< the edge that it has its vertices from; 0: none
  std::optional<std::uint32_t> point;  ///< that the edge was taken for because that was asked for
};

/// Edges that are to be taken for points, by id: how far apart the vertices may be that become one.
using EdgesAsPoints = std::map<int, double>;

struct DividedEdges {
  std::vector<Point3> points;      ///< model vertices first, then along the edges
  std::vector<DividedEdge> edges;  ///< [0] is edge 1

  std::size_t segmentCount() const;
};

/// Divides all edges, whichever faces are asked for, so that these mesh alike alone or together.
///
/// Segments are as long as the sizes want along the curve in space, or between the points that are
/// given for an edge. Closed edges have at least
/// three segments, edges with the same two ends at least two: no two edges share a segment.
///
/// Throws InputError if the points given for an edge do not lie on it, in order and apart.
DividedEdges divideEdges(const ModelShape& model, const ModelSizes& sizes, int threads,
                         std::stop_token stop, const EdgePoints& given = {},
                         const EdgesAsPoints& asPoints = {});

}  // namespace af2::geometry
