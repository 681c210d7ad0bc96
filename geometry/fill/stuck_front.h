// Reports where and why a front got stuck.
#pragma once

#include <string>
#include <vector>

#include "engine/run/algorithm.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// A message with the first edge that is left, and the reason why the most promising rule was not
/// applied.
std::string stuckReason(const MeshingResult& result, const AF2Algorithm& algorithm);

/// Some of the edges that are left, in the order of the front, with the reason of each rule.
std::vector<StuckPlace> stuckPlaces(const MeshingResult& result);

}  // namespace af2::geometry
