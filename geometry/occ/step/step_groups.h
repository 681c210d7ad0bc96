// Groups of faces by the names, layers and colours of parts in a STEP file.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/step/step_document.h"

namespace af2::geometry {

/// Each named part, each layer and each colour, in the order of the assemblies. Shapes may belong
/// to several.
std::vector<ShapeGroup> groupsOf(const StepDocument& document);

}  // namespace af2::geometry
