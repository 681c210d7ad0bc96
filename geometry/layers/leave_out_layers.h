// Layers of quadrilaterals along edges, made before the front, which begins on top of them.
// Not installed.
#pragma once

#include "engine/optimize/optimize.h"
#include "geometry/charts/charted_surface.h"
#include "geometry/layers/layer_heights.h"
#include "geometry/layers/surface_walk.h"
#include "geometry/mesh/face_boundary.h"

namespace af2::geometry {

/// How layers end where a column has one layer less than the next one: with a triangle, or with the
/// side of the last quadrilateral, which becomes an edge of the front.
enum class LayerSteps { Triangles, Sides };

inline LayerSteps stepsFor(const QuadCleanUp& quads) {
  return quads.onlyQuads ? LayerSteps::Sides : LayerSteps::Triangles;
}

/// Makes the layers of a face for which there is room, and excludes them from its loops.
///
/// place  gives points inside the face their parameters
void leaveOutLayers(const ChartedSurface& surface, const PlaceInParameters& place,
                    const EdgeLayers& layers, const DividedEdges& divided, LayerSteps steps,
                    FaceBoundary& boundary);

}  // namespace af2::geometry
