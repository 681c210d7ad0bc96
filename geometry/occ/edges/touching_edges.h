// Where edges of a face touch each other between their ends.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/edges/open_ends.h"

namespace af2::geometry {

/// Edges that touch are never farther apart than this share of the wanted size: the tolerances of
/// damaged models say otherwise, and sharp wedges are closed up to here.
constexpr double kMostBetweenTouching = 2e-3;

/// Where an edge passes a point that another edge ends at.
struct Stop {
  double parameter = 0;
  std::uint32_t point = 0;
};

/// How far apart edges of a face may lie that are taken for one, given the tolerances of both: no
/// farther than can be seen in a mesh of the wanted size.
double reachOfEdge(const ModelShape& model, int edge, double tolerance, double wanted);
/// The same for edges that begin at the same vertex: in a wedge between them that is sharper than
/// half a degree, no element can be any better than that.
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
