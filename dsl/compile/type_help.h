// The way out where a value of one type stands where another is needed.
#pragma once

#include <string>
#include <string_view>

#include "dsl/program/values.h"

namespace af2::dsl {

/// `wanted` as messages name it: "a number", "an angle", "a condition, as what is required must
/// be". Empty if there is no usual way.
std::string wayToType(std::string_view wanted, const Value& found);

}  // namespace af2::dsl
