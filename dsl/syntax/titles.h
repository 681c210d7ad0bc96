// Titles of rules in the text, and the substitution of their {parameters}.
#pragma once

#include <string>
#include <vector>

#include "dsl/syntax/ast.h"

namespace af2::dsl {

/// A title as text, {parameter}, text, ..., text: parameters have odd indices.
std::vector<std::string> titleParts(const std::string& title);

/// The titles of the rules that an item defines: its own and those of its mirror images.
std::vector<const Name*> titlesOf(const Item& item);
/// The titles of a rule and of its mirror images.
std::vector<const Name*> titlesOf(const Rule& rule);

/// Whether `pattern` gives `title` for some values of its {parameters}.
bool isTitleOf(const std::string& pattern, const std::string& title);

/// Given a `title` that `pattern` makes, returns the title that `newPattern` makes for the same
/// values. Both patterns must have the same parameters.
std::string retitled(const std::string& pattern, const std::string& title,
                     const std::string& newPattern);

/// The names of {parameters} in a title, sorted.
std::vector<std::string> titleParameters(const std::string& title);

}  // namespace af2::dsl
