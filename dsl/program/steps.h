// Steps that need nothing but the values of earlier ones.
#pragma once

#include <span>

#include "dsl/program/program.h"

namespace af2::dsl {

/// What a step without a value leaves: every step that works on it has none either.
inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

inline bool isArithmetic(Op op) { return op >= Op::Add && op <= Op::NotRightTurn; }

/// The value of an arithmetic step whose arguments are indices of `values`; NaN if it has none.
double evaluateStep(const Step& step, std::span<const double> values);

}  // namespace af2::dsl
