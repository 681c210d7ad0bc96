// Converts Netgen's rule files (.rls) to rule files of AF2.
#pragma once

#include <string>
#include <vector>

#include "dsl/text/diagnostic.h"

namespace af2::dsl {

struct ImportedRules {
  std::string text;  ///< an .af2 file; empty if there are errors
  /// Errors, and warnings about parts of the file that have no effect, are contradictory or
  /// missing.
  std::vector<Diagnostic> diagnostics;
};

/// Converts linear maps to geometry, limiting areas to fades, pairs of mirrored rules to mirrors,
/// and rules that differ in numbers only to families. Zones, points and elements have exactly the
/// numbers of the file.
///
/// name  the name of the text in diagnostics, and of the rule set
ImportedRules importRls(std::string name, std::string text);

}  // namespace af2::dsl
