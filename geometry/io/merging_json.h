// What a mesh merges, as part of reports.
// Not installed.
#pragma once

#include <nlohmann/json.hpp>

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// docs/formats.md has the fields.
nlohmann::ordered_json toJson(const Merging& merging);

}  // namespace af2::geometry
