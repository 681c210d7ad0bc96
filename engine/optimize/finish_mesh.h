// Finishes a complete mesh in the way that its rule set asks for.
#pragma once

#include "engine/base/export.h"
#include "engine/optimize/optimize.h"
#include "engine/rule/rule_set.h"
#include "engine/surface/size_field.h"

namespace af2 {

/// What a mesh is finished with, besides the mesh itself.
struct FinishTask {
  const RuleSet& rules;  ///< its `finish` chooses the way
  const AF2LocalTransformMaker& charts;
  const SizeField& size;
};

/// Finishes a complete mesh, in place, as RuleSetDefinition::finish says. The result depends only
/// on the arguments.
AF2_EXPORT OptimizeReport finishMesh(Mesh& mesh, const MeshBoundary& boundary,
                                     const FinishTask& task, const OptimizeOptions& options = {});

/// Whether a rule set asks for anything to be done after the front has closed.
inline bool finishesMeshes(const RuleSet& rules) {
  return rules.definition().finish != Finish::None;
}

}  // namespace af2
