// Tests of the places where fronts got stuck, for `af2 mesh --stuck-tests`.
#pragma once

#include "cli/meshing/mesh_request.h"
#include "engine/rule/rule_set.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::cli {

/// Writes a rule file that takes over the rules of the run and has one test for each kind of place
/// at which a front got stuck. A place is of the same kind as another if all rules are refused
/// there for the same reasons. The tests fail until a rule is applied there.
///
/// Throws InputError if the file cannot be written.
void writeStuckTests(const MeshRequest& request, const RuleSet& rules,
                     const geometry::ModelMesh& mesh);

}  // namespace af2::cli
