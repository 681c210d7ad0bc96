// The measures of a mesh as a table and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "geometry/quality/mesh_measures.h"

namespace af2::cli {

std::string measuresText(const geometry::MeshMeasures& measures);

nlohmann::ordered_json measuresJson(const geometry::MeshMeasures& measures);

}  // namespace af2::cli
