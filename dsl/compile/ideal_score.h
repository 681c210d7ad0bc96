// Finds levels at which the ideal element has no score, before the rules run.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "dsl/compile/compile_context.h"
#include "engine/base/point.h"

namespace af2::dsl {

/// The score of an element with these corners at a level; nothing if it has no score.
using ScoreAtLevel = std::function<std::optional<double>(const std::vector<Point2>&, int level)>;

/// Reports the lowest level at which the triangle with sides of length 1, or the unit square, has
/// no score.
///
/// score    the expression in the rule set corners  three or four
void checkIdealScore(CompileContext& context, const Expr& score, const Module& home, int corners,
                     int maxLevel, const ScoreAtLevel& scoreAt);

}  // namespace af2::dsl
