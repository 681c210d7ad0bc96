// Netgen's rule files (.rls) rewritten as rule files of this language.
#pragma once

#include <string>
#include <vector>

#include "dsl/text/diagnostic.h"

namespace af2::dsl {

struct ImportedRules {
  std::string text;  ///< an .af2 file; empty if there are errors
  /// Errors, and warnings about what the file says in vain, against itself, or not at all.
  std::vector<Diagnostic> diagnostics;
};

/// Linear maps become geometry, limiting areas fades, twins mirrors, rules that differ in numbers
/// only families. Zones, points and elements are what the numbers of the file say.
///
/// name  what the text is called in diagnostics; the rule set is named after it
ImportedRules importRls(std::string name, std::string text);

}  // namespace af2::dsl
