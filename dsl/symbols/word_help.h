// What the words of the language mean, in a line each, for those who write them in an editor.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dsl/text/keywords.h"

namespace af2::dsl {

struct WordHelp {
  std::string word;
  std::string_view usage;    ///< how it is written
  std::string_view meaning;  ///< one sentence
};

/// Functions, shapes, metrics, and names such as `q`.
std::vector<WordHelp> builtinHelp();

/// The row of a keyword as it is used in a block; if that block has none, the first one of another.
/// Null or nothing if there is none.
const Keyword* helpForKeyword(BlockKind block, std::string_view word);
std::optional<WordHelp> helpForBuiltin(std::string_view word);

}  // namespace af2::dsl
