// Suggestions for unknown words: "did you mean", and the equivalents of words of other languages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dsl/text/help.h"

namespace af2::dsl {

/// The text with the letters A-Z in lower case.
std::string lowered(std::string_view word);

/// The edit distance of two words: the number of letters to insert, delete, replace, or swap with a
/// neighbour.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The word of `known` that is most similar to `written`; empty if none is similar.
std::string nearest(std::string_view written, const std::vector<std::string>& known);

/// A sentence that gives the equivalent of a word of another language or of Netgen's rule files;
/// empty if there is none.
std::string habitOf(std::string_view word);

/// "did you mean 'x'?", or "`what`: x, y, z" if no word is similar and the list is short.
Help helpAmong(std::string_view written, const std::vector<std::string>& known,
               const std::string& what);

/// "did you mean 'x'?" with an edit that replaces the written word by x; empty if no word is
/// similar.
Help didYouMean(std::string_view written, const std::vector<std::string>& known);

}  // namespace af2::dsl
