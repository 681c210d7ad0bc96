// Suggests corrections for wrong elements.
#pragma once

#include <string>
#include <vector>

#include "dsl/compile/compiled_rule.h"

namespace af2::dsl {

/// The corrected corners of one element, such as "a d c". With them, all elements of the rule are
/// positive at the reference match of the first level and fit together and to the pattern. They are
/// the same corners in reverse order, or the only other corners that fit. Empty if there is no
/// unique correction, or if the element is correct.
std::string fittingElement(const CompiledRule& rule, std::size_t element);

/// The same as edits, one for each element that has a correction. A mirror image has none, because
/// its elements are written in its rule.
std::vector<SuggestedEdit> elementEdits(const CompiledRule& rule);

}  // namespace af2::dsl
