// Divides the parts of edges, whose sizes are settled.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "geometry/edges/divided_edges.h"
#include "geometry/edges/edge_points.h"
#include "geometry/layers/layer_heights.h"
#include "geometry/occ/edges/cusps.h"
#include "geometry/occ/edges/edge_parts.h"
#include "geometry/occ/edges/merged_edges.h"

namespace af2::geometry {

/// The parts of all edges of a model.
struct EdgeParts {
  std::vector<EdgePart> parts;           ///< in the order of their edges
  std::map<std::uint32_t, double> tips;  ///< by point: how long segments are at a sharp tip
  CuspLengths cusps;
  /// By point: how large the edges are that it stands for.
  std::map<std::uint32_t, double> blind;
  DividedEdges edges;  ///< with the points at the ends, without segments

  std::uint32_t addPoint(const Point3& point) {
    edges.points.push_back(point);
    return static_cast<std::uint32_t>(edges.points.size() - 1);
  }
};

/// How far from a point there are no vertices, as a multiple of how large it is.
inline constexpr double kTimesBlind = 2;

/// What divideEdges was asked for.
struct AskedOfParts {
  const EdgePoints& given;
  const SegmentChanges& changes;
  const MergedEdges& merged;
  const LayerEnds& layers;
};

/// Null: none.
inline const std::vector<Point3>* pointsGivenFor(const EdgePoints& given, std::size_t edge) {
  const auto found = given.find(static_cast<int>(edge) + 1);
  return found == given.end() ? nullptr : &found->second;
}

/// Throws InputError if the points given for an edge are not on it, in order and distinct.
DividedEdges divideParts(const ModelShape& model, const CadSizes& sizes, const AskedOfParts& asked,
                         int threads, EdgeParts parts);

}  // namespace af2::geometry
