// Finds elements that cross in a mesh that lies on disk.
// Not installed.
#pragma once

#include <vector>

#include "geometry/check/element_crossings.h"
#include "geometry/check/spooled_faults.h"

namespace af2::geometry {

/// What `elementCrossings` finds in the same mesh in memory. At most two faces for each call of the
/// work are loaded at once.
std::vector<Crossing> spooledCrossings(const ModelMesh& mesh, const EvidenceOfParts& evidence,
                                       const Repeat& repeat);

}  // namespace af2::geometry
