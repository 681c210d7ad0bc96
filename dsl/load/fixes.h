// Mending what can be mended without asking: `af2 check --fix`.
#pragma once

#include <string>
#include <vector>

#include "dsl/load/rule_file.h"
#include "engine/base/export.h"

namespace af2::dsl {

/// A stretch of a text that becomes another one.
struct TextEdit {
  Span span;
  std::string replacement;
  std::string what;  ///< a phrase: "'HH' becomes 'H'"
};

/// The edits that the findings about a file bring along: words that "did you mean" knows better,
/// signs that are missing or too many, corners of elements in the wrong order, mirror clauses that
/// are missing or do nothing. Comments and layout stay.
AF2_EXPORT std::vector<TextEdit> editsFor(const LoadedRules& loaded);

struct FixedText {
  std::string text;
  std::vector<std::string> done;  ///< what was changed, in order
};

/// Makes edits one after another, and keeps each of them only if the file is better for it: fewer
/// errors in its signs; or as many, and fewer in names and types; and so on down to warnings.
AF2_EXPORT FixedText fixText(const std::string& name, std::string text,
                             const LoadOptions& options = {});

}  // namespace af2::dsl
