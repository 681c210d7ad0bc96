// How many layers there is room for. Not installed.
#pragma once

#include "geometry/layers/layer_columns.h"

namespace af2::geometry {

/// Takes layers away from columns until no element is inverted or too narrow, and until layers,
/// made a quarter higher, cross neither each other nor the boundary. Then neighbouring columns
/// differ by at most one layer.
void limitLayers(const FaceBoundary& boundary, LayerGrid& grid);

}  // namespace af2::geometry
