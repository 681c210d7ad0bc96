// Checks of a region's boundary before meshing, and what can be derived from it beforehand.
#pragma once

#include <optional>

#include "engine/front/front_index.h"
#include "engine/mesh/front_input.h"
#include "engine/surface/size_field.h"

namespace af2 {

/// Throws InputError if the input is not a set of closed loops (see AF2Algorithm::execute).
void checkInput(const FrontInput& input);

/// The wanted length at a point. Throws InputError if that is not a positive number.
double checkedSizeAt(const SizeField& field, const SurfacePoint& point);

/// For a flat region: throws InputError if the boundary runs the wrong way round (a front that runs
/// outwards would never end), and returns where vertices can lie. For other regions nothing can be
/// said.
std::optional<Box3> limitsOfFlatRegion(const FrontInput& input);

/// An empty index for the front of a region.
FrontIndex makeIndex(const FrontInput& input);

}  // namespace af2
