// Combines rules that differ in numbers only into one rule with `for`.
#pragma once

#include <string>
#include <vector>

namespace af2::dsl {

/// A rule as text, with separate title and quality.
struct RuleText {
  std::string title;
  int quality = 1;
  std::vector<std::string> remarks;
  std::vector<std::string> clauses;  ///< each with its ';' or closing brace
  bool hasMirror = false;
};

/// The text of a file with these rules. Of rules that differ in numbers only, the first is kept,
/// with its numbers as parameters.
std::string writeRules(const std::vector<RuleText>& rules);

}  // namespace af2::dsl
