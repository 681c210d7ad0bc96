// The area of a face of the model, from its surface and its boundary.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Area of a face of the model, to about five digits; 0 if it cannot be computed. It does not
/// depend on the division of edges or on any mesh.
double areaOf(const ModelShape& model, int face);
/// The area of the part of a creased face in one of its cells.
double areaOf(const ModelShape& model, int face, const Stretch& u, const Stretch& v);

}  // namespace af2::geometry
