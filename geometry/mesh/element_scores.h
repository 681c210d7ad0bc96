// How good the elements of a mesh are by the metric of the rule set that made them.
#pragma once

#include <vector>

#include "engine/base/export.h"
#include "engine/rule/rule_set.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// The badness of each element, 0 being ideal; NaN where the metric has no value.
///
/// The corners are laid out in the plane of the element, in the order in which its rule named them,
/// with the chart unit of the rule set: the mean of the wanted sizes at the corners, or the length
/// of the first side. The level is that of the element's origin, at least 1. An element that
/// optimisation changed has no such order; it gets the best value of all its rotations.
///
/// threads  0: as many as the caller's TBB arena has
AF2_EXPORT std::vector<float> elementScores(const ModelMesh& mesh, const RuleSetDefinition& rules,
                                            int threads);

/// Stores them in the mesh: on disk if that is where its elements are.
AF2_EXPORT void scoreElements(ModelMesh& mesh, const RuleSetDefinition& rules, int threads);

}  // namespace af2::geometry
