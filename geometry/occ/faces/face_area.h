// The area of a face of the model, from its surface and its boundary.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Area of a face of the model, to about five digits; 0 if it cannot be told. Independent of how
/// edges are divided and of any mesh.
double areaOf(const ModelShape& model, int face);
/// Of the part of a face with creases that lies in one of its cells.
double areaOf(const ModelShape& model, int face, const Stretch& u, const Stretch& v);

}  // namespace af2::geometry
