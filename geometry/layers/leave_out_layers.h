// Layers of quadrilaterals along edges, made before the front, which begins on top of them.
// Not installed.
#pragma once

#include "geometry/charts/charted_surface.h"
#include "geometry/layers/layer_heights.h"
#include "geometry/layers/surface_walk.h"
#include "geometry/mesh/face_boundary.h"

namespace af2::geometry {

/// Makes the layers of a face for which there is room, and excludes them from its loops.
///
/// place  gives points inside the face their parameters
void leaveOutLayers(const ChartedSurface& surface, const PlaceInParameters& place,
                    const EdgeLayers& layers, const DividedEdges& divided, FaceBoundary& boundary);

}  // namespace af2::geometry
