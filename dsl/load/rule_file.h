// Rule files: from a path or a text to an immutable rule set, with all that is to be said about it.
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "dsl/compile/compiled_rule.h"
#include "dsl/compile/module.h"
#include "dsl/compile/test_compiler.h"
#include "dsl/program/registry.h"
#include "dsl/text/diagnostic.h"
#include "engine/rule/rule_set.h"

namespace af2::dsl {

struct LoadOptions {
  /// Where imports are looked for after the folder of the importing file.
  std::vector<std::filesystem::path> searchPaths;
  /// Functions, metrics and zone shapes of the caller; null: none.
  const Registry* registry = nullptr;
  /// Texts that stand for files, asked before the disk is: what an editor has not saved yet.
  TextSource unsaved;
  /// Codes of warnings that are not told.
  std::vector<std::string> allowed;
  /// Whether the file is to be run, which takes a rule set and rules. Without, a file may be a
  /// library: its rules get the default settings.
  bool needsRuleSet = true;
};

/// The files and rules behind a rule set, for tests, pictures and further checks.
struct LoadedFile {
  std::vector<std::unique_ptr<Module>> modules;  ///< [0] is the file itself, then its imports
  std::vector<CompiledRule> rules;               ///< those of `soundRules` first, in its order
  /// The rule set; of a file with errors what is sound of it, so that further checks can tell all
  /// mistakes in one run. Null if there is no rule set, or nothing sound.
  std::shared_ptr<const RuleSet> soundRules;
  std::vector<CompiledTest> tests;  ///< of the file itself, those without errors
  std::vector<CompiledProperty> properties;
  std::set<std::string> allowed;  ///< codes that the rule set allows, for all rules
  const Module& main() const { return *modules.front(); }
};

struct LoadedRules {
  std::shared_ptr<const RuleSet> rules;  ///< null if there are errors, or a library has no rules
  std::vector<Diagnostic> diagnostics;   ///< errors and warnings, in the order of the text
  std::shared_ptr<const LoadedFile> file;
};

/// Never throws on what stands in the file, nor when there is none: that is a diagnostic (R3).
LoadedRules loadRules(const std::filesystem::path& path, const LoadOptions& options = {});

/// `name` is what diagnostics call the text; imports are looked for beside it.
LoadedRules loadRulesFromText(std::string name, std::string text, const LoadOptions& options = {});

}  // namespace af2::dsl
