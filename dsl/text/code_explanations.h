// What each diagnostic code means, for `af2 explain-code`.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace af2::dsl {

struct CodeExplanation {
  std::string code;   ///< such as "A1"
  std::string title;  ///< one line
  std::string text;   ///< cause, example and way out
};

/// All codes, sorted by series and number.
std::span<const CodeExplanation> codeExplanations();

/// Takes "A1" and "AF2-A1", in either case. Null if there is no such code.
const CodeExplanation* findCodeExplanation(std::string_view code);

}  // namespace af2::dsl
