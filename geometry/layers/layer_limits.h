// How many layers there is room for. Not installed.
#pragma once

#include "geometry/layers/layer_columns.h"

namespace af2::geometry {

/// Makes columns lower until no element is inverted or too narrow, and until layers, made a quarter
/// higher, cross neither each other nor the boundary: first thinner, then with fewer layers. The
/// heights of neighbouring columns differ little, and by at most one layer.
void limitLayers(const FaceBoundary& boundary, const SurfaceWalk& walk, LayerGrid& grid);

}  // namespace af2::geometry
