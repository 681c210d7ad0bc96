// The last resort of a front that keeps its loops even: a path of new edges across a loop.
// Not installed.
#pragma once

#include <optional>
#include <vector>

#include "engine/run/advance.h"
#include "engine/step/compiled_rules.h"
#include "engine/surface/size_field.h"

namespace af2 {

/// A straight path, as a chart shows it, between two places of one loop.
struct LoopPath {
  const CompiledRule* rule = nullptr;
  PlaceId from, to;
  std::vector<SurfacePoint> points;  ///< the new vertices, in order; may be none
  double score = 0;
};

/// The path with the lowest score that a rule with `path` makes across the shortest loop: it runs
/// through free space alone, has as many edges as keep both parts even, and leaves two shorter
/// loops. Ties go to the earlier rule and place.
std::optional<LoopPath> bestPath(const Advance& advance, const CompiledRules& rules,
                                 const SizeField& size, const std::vector<std::uint8_t>& valence);

}  // namespace af2
