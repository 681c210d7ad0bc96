// Steps that need nothing but the values of earlier ones.
#pragma once

#include <limits>
#include <span>

#include "dsl/program/program.h"

namespace af2::dsl {

/// What a step without a value leaves: every step that works on it has none either.
inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// The value of an arithmetic step whose arguments are indices of `values`; NaN if it has none.
double evaluateStep(const Step& step, std::span<const double> values);

/// Calls a registered function with the values of steps; NaN where it has no value.
double call(const UserFunction& function, const std::array<Node, Step::kMostArguments>& arguments,
            std::span<const double> values);

}  // namespace af2::dsl
