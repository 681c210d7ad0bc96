#include "dsl/code_explanations.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace af2::dsl {

std::span<const CodeExplanation> codeExplanations() { return {}; }

const CodeExplanation* findCodeExplanation(std::string_view) { return nullptr; }

}  // namespace af2::dsl
