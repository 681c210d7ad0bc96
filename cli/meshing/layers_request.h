// The option that asks for layers of quadrilaterals along edges.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "geometry/layers/layer_request.h"

namespace af2::cli {

void declareLayers(CLI::App& command, std::vector<std::string>& layers);

/// Items such as "3,7-9=0.01,1.2,5" or "wall@2=0.01,1.2,5". Throws UsageError.
std::vector<geometry::LayerRequest> checkedLayers(const std::vector<std::string>& layers);

}  // namespace af2::cli
