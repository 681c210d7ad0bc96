// Why fronts got stuck, grouped by cause, for the terminal and the report of `af2 mesh`.
#pragma once

#include <string>

#include "geometry/mesh/model_mesh.h"

namespace af2::cli {

/// The most frequent cause with a remedy, and where to find out more; empty if no front got stuck.
std::string stuckText(const geometry::ModelMesh& mesh);

/// A JSON array with an object for each cause, the most frequent first: `cause`, `places` (how many
/// of the reported places), `faces`, `rules` (titles of the rules that it refused there, and how
/// often), `remedy`.
std::string stuckJson(const geometry::ModelMesh& mesh);

}  // namespace af2::cli
