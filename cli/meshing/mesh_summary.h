// The texts that `af2 mesh` prints at the end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh/model_mesh.h"
#include "geometry/mesh/quality.h"

namespace af2::cli {

/// Counts, quality (unless there is no mesh) and times.
std::string summaryText(const geometry::ModelMesh& mesh, const geometry::MeshQuality& quality);

/// The changes made by healing, one line each; empty if nothing was healed.
std::string healingText(const std::optional<geometry::Healing>& healing);
/// What an imprint has done; empty if it was not asked for, or was undone.
std::string imprintText(const std::optional<geometry::Imprinting>& imprinting);
/// What was merged; empty if that was not asked for.
std::string mergeText(const std::optional<geometry::Merging>& merging);
/// Why an imprint was undone, for people who asked for it; empty if it was not.
std::string imprintFault(const std::optional<geometry::Imprinting>& imprinting);

/// Says that AF2's lengths are not in the unit of the file; empty if they are, or if unknown.
std::string unitText(const geometry::ModelMesh& mesh);

/// The repairs made while reading, one line each; empty if there were none.
std::string notesText(const std::vector<std::string>& notes);

/// How many elements no rule made, and on which faces; empty if there are none.
std::string withoutRuleText(const geometry::ModelMesh& mesh);

/// For a mesh that should have quadrilaterals only: which faces have triangles, and why; empty if
/// none has.
std::string trianglesText(const geometry::ModelMesh& mesh);

/// One line for each failed face, with the reason; empty if none failed.
std::string failureText(const geometry::ModelMesh& mesh);

/// 1234567 as "1 234 567".
std::string grouped(std::size_t number);

/// The number of elements of layers, and where there are fewer layers than asked; empty if none
/// were asked for.
std::string layersText(const geometry::ModelMesh& mesh);

}  // namespace af2::cli
