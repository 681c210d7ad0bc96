// Steps that need only the values of earlier steps.
#pragma once

#include <limits>
#include <span>

#include "dsl/program/program.h"

namespace af2::dsl {

/// The result of a step without a value. Steps that use it have no value either.
inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// The value of an arithmetic step whose arguments are indices of `values`; NaN if it has none.
double evaluateStep(const Step& step, std::span<const double> values);

/// Calls a registered function with the values of steps; NaN if it has no value.
double call(const UserFunction& function, const std::array<Node, Step::kMaxArguments>& arguments,
            std::span<const double> values);

}  // namespace af2::dsl
