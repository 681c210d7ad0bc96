// What is asked of a region before it is meshed, and what can be told of it beforehand.
#pragma once

#include <optional>

#include "engine/front/front_index.h"
#include "engine/mesh/front_input.h"
#include "engine/surface/size_field.h"

namespace af2 {

/// Throws InputError if the input is no set of closed loops (see AF2Algorithm::execute).
void checkInput(const FrontInput& input);

/// The wanted length at a point. Throws InputError if that is no positive number.
double checkedSizeAt(const SizeField& field, const SurfacePoint& point);

/// Of a flat region it can be told beforehand whether its boundary runs the right way round, which
/// throws InputError if not, and where no vertex can lie: a front that runs outwards would never
/// end. Nothing of a region that is not flat.
std::optional<Box3> limitsOfFlatRegion(const FrontInput& input);

/// An empty index for the front of a region.
FrontIndex makeIndex(const FrontInput& input);

}  // namespace af2
