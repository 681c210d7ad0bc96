// Levels at which the best element there is has no score: told ahead of a run.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "dsl/compile/compile_context.h"
#include "engine/base/point.h"

namespace af2::dsl {

/// What an element with these corners scores at a level; nothing: it has no score.
using ScoreAtLevel = std::function<std::optional<double>(const std::vector<Point2>&, int level)>;

/// Tells of the lowest level, if there is one, at which the triangle with sides of 1, or the unit
/// square, has no score.
///
/// score    where the rule set gives it
/// corners  three or four
void checkIdealScore(CompileContext& context, const Expr& score, const Module& home, int corners,
                     int maxLevel, const ScoreAtLevel& scoreAt);

}  // namespace af2::dsl
