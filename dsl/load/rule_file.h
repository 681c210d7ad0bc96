// Rule files: from a path or a text to an immutable rule set, with all that is to be said about it.
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

struct LoadOptions {
  /// Where imports are looked for after the folder of the importing file.
  std::vector<std::filesystem::path> searchPaths;
  /// Functions, metrics and zone shapes of the caller; null: none.
  const Registry* registry = nullptr;
  /// Texts that stand for files, asked before the disk is: what an editor has not saved yet.
  TextSource unsaved;
  /// Codes of warnings that are not told.
  std::vector<Code> allowed;
  /// Whether the file is to be run, which takes a rule set and rules. Without, a file may be a
  /// library: its rules get the default settings.
  bool needsRuleSet = true;
};

struct LoadedRules {
  std::shared_ptr<const RuleSet> rules;    ///< null if there are errors, or a library has no rules
  std::vector<Diagnostic> diagnostics;     ///< errors and warnings, in the order of the text
  std::shared_ptr<const LoadedFile> file;  ///< what the rules were made of
};

/// Never throws on what stands in the file, nor when there is none: that is a diagnostic (R3).
AF2_EXPORT LoadedRules loadRules(const std::filesystem::path& path,
                                 const LoadOptions& options = {});

/// `name` is what diagnostics call the text; imports are looked for beside it.
AF2_EXPORT LoadedRules loadRulesFromText(std::string name, std::string text,
                                         const LoadOptions& options = {});

}  // namespace af2::dsl
