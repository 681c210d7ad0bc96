// Steps that need nothing but the values of earlier ones.
#pragma once

#include <span>

#include "dsl/program.h"

namespace af2::dsl {

inline bool isArithmetic(Op op) { return op >= Op::Add && op <= Op::NotRightTurn; }

/// The value of an arithmetic step whose arguments are indices of `values`; NaN if it has none.
double evaluateStep(const Step& step, std::span<const double> values);

}  // namespace af2::dsl
