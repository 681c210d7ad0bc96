// `af2 inspect --json`: a CAD model in numbers, for programs.
#pragma once

#include <optional>
#include <string>

#include "geometry/mesh/model_mesh.h"
#include "geometry/occ/model/model.h"

namespace af2::cli {

/// What a mesh of a size would merge.
struct MergingAtSize {
  double size;
  geometry::Merging merging;
};

/// docs/formats.md has the fields.
std::string inspectJson(const geometry::Model& model,
                        const std::optional<MergingAtSize>& merging = {});

}  // namespace af2::cli
