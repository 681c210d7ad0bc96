// What a wrong element was probably meant to be.
#pragma once

#include <string>
#include <vector>

#include "dsl/compile/compiled_rule.h"

namespace af2::dsl {

/// The corners of one element, "a d c", with which all elements of a rule would be positive at its
/// reference match of its first level, and fit together and to the pattern: the same corners the
/// other way round, or the only others that there are. Empty if that is not clear, or nothing is
/// wrong with it.
std::string fittingElement(const CompiledRule& rule, std::size_t element);

/// The same as edits, one for each element that has such corners; none for a mirror image, whose
/// elements are those of its rule.
std::vector<SuggestedEdit> elementEdits(const CompiledRule& rule);

}  // namespace af2::dsl
