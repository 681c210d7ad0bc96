// `af2 inspect --json`: a CAD model in numbers, for programs.
#pragma once

#include <string>

#include "geometry/occ/model/model.h"

namespace af2::cli {

/// docs/formats.md has the fields.
std::string inspectJson(const geometry::Model& model);

}  // namespace af2::cli
