// What `af2 mesh` tells at the end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh/model_mesh.h"
#include "geometry/mesh/quality.h"

namespace af2::cli {

/// What was made, how good it is (unless there is no mesh), how long it took.
std::string summaryText(const geometry::ModelMesh& mesh, const geometry::MeshQuality& quality);

/// What healing changed, one line each; empty if nothing was healed.
std::string healingText(const std::optional<geometry::Healing>& healing);

/// That lengths are not in the unit of the file; empty if they are, or nobody knows.
std::string unitText(const geometry::ModelMesh& mesh);

/// What was put right while reading, one line each; empty if nothing was.
std::string notesText(const std::vector<std::string>& notes);

/// One line for each face that failed, with its reason; empty if none did.
std::string failureText(const geometry::ModelMesh& mesh);

/// 1234567 as "1 234 567".
std::string grouped(std::size_t number);

}  // namespace af2::cli
