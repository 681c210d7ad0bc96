// The volume of the solids of a model.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <optional>

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// From the surfaces and boundaries of the faces, to about 1e-5 of their area times the diagonal
/// of the model. None if a face belongs to no solid, or has no surface or area.
std::optional<double> volumeOfSolids(const ModelShape& model);

}  // namespace af2::geometry
