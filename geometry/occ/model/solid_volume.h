// The volume of the solids of a model.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <optional>

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// None if a face belongs to no solid, or OpenCASCADE fails.
std::optional<double> volumeOfSolids(const ModelShape& model);

}  // namespace af2::geometry
