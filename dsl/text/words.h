// What may be meant by a word that means nothing: "did you mean", and habits from other languages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dsl/text/help.h"

namespace af2::dsl {

/// Capital letters of the English alphabet become small ones.
std::string lowered(std::string_view word);

/// How many letters must be put in, taken out, replaced, or swapped with their neighbour to make
/// one word of another.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The word of `known` that is most probably meant by `written`; empty if none is near.
std::string nearest(std::string_view written, const std::vector<std::string>& known);

/// What a word of other languages, or of Netgen's rule files, is called here: a whole sentence, or
/// nothing.
std::string habitOf(std::string_view word);

/// "did you mean 'x'?", or else "`what`: x, y, z" where those are few.
Help helpAmong(std::string_view written, const std::vector<std::string>& known,
               const std::string& what);

/// "did you mean 'x'?", which puts x in place of what is written, or nothing.
Help didYouMean(std::string_view written, const std::vector<std::string>& known);

}  // namespace af2::dsl
