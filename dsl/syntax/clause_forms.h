// How each item and clause is written: one example of its form, shown where one is broken.
#pragma once

#include <string_view>

#include "dsl/syntax/syntax_errors.h"

namespace af2::dsl {

/// An example of what begins with `word` in such a unit, in backticks; empty if nothing does.
std::string_view formOf(SyntaxUnit unit, std::string_view word);

}  // namespace af2::dsl
