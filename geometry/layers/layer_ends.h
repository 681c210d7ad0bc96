// Where layers end on edges that have no layers: these get vertices at the heights of the layers,
// so that all faces at them see the same vertices. Not installed.
#pragma once

#include "geometry/layers/layer_runs.h"

namespace af2::geometry {

/// Adds the vertices that layers of a face need on other edges. Lengths that an edge has already
/// stay. There are as many as fit on the edge.
///
/// divided  the edges without such vertices
void addLayerEnds(const FaceBoundary& boundary, const EdgeLayers& layers,
                  const DividedEdges& divided, LayerEnds& ends);

/// Leaves as many vertices as fit between the ends of each edge.
void fitLayerEnds(const DividedEdges& divided, LayerEnds& ends);

}  // namespace af2::geometry
