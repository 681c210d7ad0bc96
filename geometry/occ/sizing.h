// Wanted sizes as the options give them, and their limits by curvature.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include "geometry/occ/face_surface.h"
#include "geometry/occ/mesh_model.h"

namespace af2::geometry {

/// Throws InputError for a size that is not positive or an id that the model does not have.
void checkSizes(const ModelSizes& sizes, const Model& model);

/// The size for a face as the options say it, before all limits.
double wantedOnFace(const ModelSizes& sizes, int face);

/// The function's limit at a position, if there is a function. Throws InputError unless it gives a
/// positive size.
double limitByFunction(const ModelSizes& sizes, double size, const Point3& position);

/// `size`, or less where an edge of an element would turn by more than sizes.faceTurn.
double limitByCurvature(const ModelSizes& sizes, double size, const FaceSurface& surface,
                        const SurfacePoint& point);

}  // namespace af2::geometry
