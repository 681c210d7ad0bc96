// What the words of the language mean, in a line each, for those who write them in an editor.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace af2::dsl {

struct WordHelp {
  std::string_view word;
  std::string_view usage;    ///< how it is written
  std::string_view meaning;  ///< one sentence
};

/// Words that begin items and clauses. One word may stand in blocks of two kinds, as `front` does;
/// then the help covers both.
std::span<const WordHelp> keywordHelp();
/// Functions, shapes, metrics, and names such as `q`.
std::vector<WordHelp> builtinHelp();

/// Null or nothing if there is none.
const WordHelp* helpForKeyword(std::string_view word);
std::optional<WordHelp> helpForBuiltin(std::string_view word);

}  // namespace af2::dsl
