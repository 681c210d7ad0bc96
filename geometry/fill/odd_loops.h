// Loops that cannot be filled with quadrilaterals alone, and how to change that. Not installed.
#pragma once

#include <vector>

#include "engine/mesh/front_input.h"
#include "engine/surface/size_field.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// The loops with an odd number of segments.
///
/// wanted  null: the segments to divide are not needed
std::vector<FaceReport::OddLoop> oddLoopsOf(const FrontInput& input, const SizeField* wanted);

}  // namespace af2::geometry
