// Titles of rules as they stand in the text, whether the rules are sound or not.
#pragma once

#include <string_view>
#include <vector>

#include "dsl/ast.h"

namespace af2::dsl {

/// The titles that an item gives to rules: its own and those of its mirror images.
std::vector<const Name*> titlesOf(const Item& item);

/// Whether `title` may be what `written` becomes when its parameters are filled in.
bool mayBecome(std::string_view written, std::string_view title);

}  // namespace af2::dsl
