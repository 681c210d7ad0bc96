// Edges that are so short that they count as points, and gaps between ends of edges.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/edges/open_ends.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// The length of an edge; if it is closed, how far its points are apart: it is the whole edge that
/// is, or is not, within the tolerance of its vertex.
double spanOf(const EdgeSamples& samples, const Ends& ends);

/// How long an edge may be to be taken for a point: longer at the end of a sliver than between two
/// sides of something thin, which would fall onto each other.
///
/// edge           an id
/// ends, samples  by edge; [0] is edge 1
double pointLength(const ModelShape& model, int edge, const std::vector<Ends>& ends,
                   const std::vector<EdgeSamples>& samples);

/// Ends in wires that lie apart by no more than the tolerances of their vertices, as gapsInWires.
///
/// size    wanted everywhere
/// isUsed  by edge, [0] is edge 1: it is no point
std::vector<std::pair<std::uint32_t, std::uint32_t>> gapsBetweenEnds(
    const ModelShape& model, double size, const std::vector<Ends>& ends,
    const std::vector<bool>& isUsed, const std::vector<Point3>& points);

}  // namespace af2::geometry
