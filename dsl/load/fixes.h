// Corrects faults automatically, for `af2 check --fix`.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "dsl/load/rule_file.h"
#include "engine/base/export.h"

namespace af2::dsl {

/// A replacement of a part of a text.
struct TextEdit {
  Span span;
  std::string replacement;
  std::string what;  ///< a phrase: "'HH' becomes 'H'"
};

/// The edits of the findings about a file: words with a "did you mean" suggestion, missing or extra
/// symbols, corners of elements in the wrong order, missing or redundant mirror clauses. Comments
/// and layout do not change.
AF2_EXPORT std::vector<TextEdit> editsFor(const LoadedRules& loaded);

struct FixedText {
  std::string text;
  std::vector<std::string> done;  ///< the changes, in order
};

/// Removes findings about a file that further checks have shown not to be worth an edit.
using DropFindings = std::function<void(const LoadedRules& loaded, std::vector<Diagnostic>& told)>;

/// Makes edits one after another, and keeps an edit only if it improves the file: fewer errors in
/// words and clauses, or equally many and fewer in names and types, and so on down to warnings.
AF2_EXPORT FixedText fixText(const std::string& name, std::string text,
                             const LoadOptions& options = {}, const DropFindings& drop = {});

}  // namespace af2::dsl
