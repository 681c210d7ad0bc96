// Rules that differ in numbers only become one rule with `for`.
#pragma once

#include <string>
#include <vector>

namespace af2::dsl {

/// A rule as text, title and quality apart.
struct RuleText {
  std::string title;
  int quality = 1;
  std::vector<std::string> remarks;
  std::vector<std::string> clauses;  ///< each with its ';' or closing brace
  bool hasMirror = false;
};

/// The rules as text of a file. Of rules with the same words and signs only the first is kept, with
/// its numbers as parameters.
std::string writeRules(const std::vector<RuleText>& rules);

}  // namespace af2::dsl
