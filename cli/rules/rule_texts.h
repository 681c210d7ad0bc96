// Where the rules of a rule set are written, for people who look at its meshes.
#pragma once

#include <vector>

#include "dsl/load/rule_file.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::cli {

/// By rule of the rule set. Files in the folder of the rules of AF2 are named relative to it, so
/// that a mesh does not depend on where AF2 is installed.
std::vector<geometry::RuleText> ruleTextsOf(const dsl::LoadedRules& loaded);

}  // namespace af2::cli
