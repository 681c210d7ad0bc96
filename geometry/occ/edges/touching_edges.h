// Finds where edges of a face touch each other between their ends.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/occ/edges/edge_parts.h"
#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/edges/open_ends.h"

namespace af2::geometry {

/// Edges count as touching only up to this share of the wanted size: the tolerances of damaged
/// models may be larger, and sharp wedges are closed up to this distance.
constexpr double kMaxBetweenTouching = 2e-3;

/// A place where an edge passes a point at which another edge ends.
struct Stop {
  double parameter = 0;
  std::uint32_t point = 0;
};

/// The parts of an edge between its stops.
std::vector<EdgePart> partsBetween(std::size_t edge, EdgeSamples samples, const Ends& ends,
                                   const std::vector<Stop>& stops);

/// The distance up to which edges of a face count as one, given the tolerances of both: no more
/// than is visible in a mesh of the wanted size.
double reachOfEdge(const ModelShape& model, int edge, double tolerance, double wanted);
/// The same for edges that begin at the same vertex: in a wedge between them that is sharper than
/// half a degree, no element can have a larger angle.
double reachInWedge(double reach, double wanted, double fromVertex);

/// By edge, and in order along it: the points at which other edges of a face end on it, between its
/// own ends. [0] is edge 1, as in `ends` and `samples`.
///
/// points     of the model's vertices first
/// mayBeSplit by edge
std::vector<std::vector<Stop>> stopsOf(const ModelShape& model, const std::vector<Ends>& ends,
                                       const std::vector<EdgeSamples>& samples,
                                       const std::vector<Point3>& points,
                                       const std::vector<bool>& mayBeSplit);

}  // namespace af2::geometry
