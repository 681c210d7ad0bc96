// Suggests corrections for wrong elements.
#pragma once

#include <string>
#include <vector>

#include "dsl/compile/compiled_rule.h"

namespace af2::dsl {

/// Corners with which all elements of a rule would be positive at the reference match of its first
/// level, and fit together and to the pattern.
struct FittingElement {
  std::string corners;       ///< "a d c"; empty: it is not clear what was meant
  bool isReordered = false;  ///< they are the corners that are written, in another order
};

/// What was meant by one element. The same corners in another order are a slip of the pen wherever
/// they fit. Other corners are proposed only in place of an element that is wrong by itself (it
/// does not turn left, or has an edge that another element or the front has), if one corner alone
/// differs and nothing else fits: an element that is right by itself is not misspelt.
FittingElement fittingElement(const CompiledRule& rule, std::size_t element);

/// The same as the way out of a diagnostic; empty if nothing fits. `place` follows the corners:
/// " as element 2".
std::string fittingHelp(const CompiledRule& rule, std::size_t element,
                        const std::string& place = {});

/// The same as edits, one for each element that has a correction. A mirror image has none, because
/// its elements are written in its rule.
std::vector<SuggestedEdit> elementEdits(const CompiledRule& rule);

}  // namespace af2::dsl
