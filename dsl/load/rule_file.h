// Loads rule files: from a path or a text to an immutable rule set with its diagnostics.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "dsl/text/diagnostic.h"
#include "dsl/text/source_text.h"
#include "engine/base/export.h"
#include "engine/rule/rule_set.h"

namespace af2::dsl {

class Registry;
struct LoadedFile;  // loaded_file.h, for AF2 itself

/// Whether the names that a file declares with `extern` must be registered.
enum class Externs {
  Registered,  ///< R6 if a name that the rules use is not: to evaluate the rules
  Declared,    ///< to check or to show rules; what needs a missing name counts as unknown
};

struct LoadOptions {
  /// The folders in which imports are searched after the folder of the importing file.
  std::vector<std::filesystem::path> searchPaths;
  /// Registered functions, metrics and zone shapes; null if there are none.
  const Registry* registry = nullptr;
  Externs externs = Externs::Registered;
  /// Supplies texts in place of files on the disk, such as the unsaved files of an editor.
  TextSource unsaved;
  /// Codes of warnings that are not reported.
  std::vector<Code> allowed;
  /// Whether the file must be complete, with a rule set and rules. Otherwise the file may be a
  /// library, whose rules get the default settings.
  bool needsRuleSet = true;
};

struct LoadedRules {
  std::shared_ptr<const RuleSet> rules;    ///< null if there are errors, or a library has no rules
  std::vector<Diagnostic> diagnostics;     ///< errors and warnings, in the order of the text
  std::shared_ptr<const LoadedFile> file;  ///< the source of the rules
};

/// Never throws because of the content of the file. A missing file is a diagnostic (R3).
AF2_EXPORT LoadedRules loadRules(const std::filesystem::path& path,
                                 const LoadOptions& options = {});

/// `name` is the name of the text in diagnostics; imports are searched in its folder.
AF2_EXPORT LoadedRules loadRulesFromText(std::string name, std::string text,
                                         const LoadOptions& options = {});

}  // namespace af2::dsl
