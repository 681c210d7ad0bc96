// Divides each edge of a model once, so that the faces on both sides share its vertices.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <stop_token>
#include <vector>

#include "geometry/edges/divided_edges.h"
#include "geometry/edges/edge_points.h"
#include "geometry/layers/layer_heights.h"
#include "geometry/occ/edges/merged_edges.h"
#include "geometry/occ/edges/narrow_strips.h"
#include "geometry/occ/edges/sampled_edges.h"
#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/sizes/cad_sizes.h"

namespace af2::geometry {

/// Divides all edges, whichever faces are requested, so that a face gets the same mesh alone or
/// together with others.
///
/// Segments have the wanted sizes along the curve in space, or end at the points that are given for
/// an edge. Closed edges have at least three segments, edges with the same two ends at least two,
/// so that no two edges share a segment.
///
/// sampled  with a function whose sizes are nowhere smaller than those of `sizes`
/// changes  by count of the division without changes. Where a change is not possible, the number of
///          segments stays as it is.
/// merged   edges that are not divided, because the mesh does not follow them, and chains that are
///          divided as one edge
/// ends     of layers: there edges without given points have vertices
/// strips   of an earlier division of the same samples, with the same given points and merged
///          edges; may be null
///
/// Throws InputError if the points given for an edge are not on it, in order and distinct.
DividedEdges divideEdges(const ModelShape& model, const SampledEdges& sampled,
                         const CadSizes& sizes, int threads, const std::stop_token& stop,
                         const EdgePoints& given = {}, const CollapsedEdges& asPoints = {},
                         const SegmentChanges& changes = {}, const MergedEdges& merged = {},
                         const LayerEnds& ends = {}, KnownStrips* strips = nullptr);

}  // namespace af2::geometry
