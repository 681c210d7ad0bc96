// One-line descriptions of the words of the language, for editors.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dsl/text/keywords.h"

namespace af2::dsl {

struct WordHelp {
  std::string word;
  std::string_view usage;    ///< the form of its use
  std::string_view meaning;  ///< one sentence
};

/// Functions, shapes, metrics, and names such as `q`.
std::vector<WordHelp> builtinHelp();

/// The row of a keyword in a block, or its first row in another block if this block has none. Null
/// or nothing if there is none.
const Keyword* helpForKeyword(BlockKind block, std::string_view word);
std::optional<WordHelp> helpForBuiltin(std::string_view word);

}  // namespace af2::dsl
