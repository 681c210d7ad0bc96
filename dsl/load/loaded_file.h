// What a rule set was made of: its files, rules and tests as they were written.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "dsl/compile/compiled_rule.h"
#include "dsl/compile/module.h"
#include "dsl/compile/test_compiler.h"
#include "engine/rule/rule_set.h"

namespace af2::dsl {

/// The files and rules behind a rule set, for tests, pictures and further checks.
struct LoadedFile {
  std::vector<std::unique_ptr<Module>> modules;  ///< [0] is the file itself, then its imports
  std::vector<CompiledRule> rules;               ///< those of `soundRules` first, in its order
  /// The rule set; of a file with errors what is sound of it, so that further checks can tell all
  /// mistakes in one run. Null if there is no rule set, or nothing sound.
  std::shared_ptr<const RuleSet> soundRules;
  std::vector<CompiledTest> tests;  ///< of the file itself, those without errors
  std::vector<CompiledProperty> properties;
  std::set<Code> allowed;  ///< codes that the rule set allows, for all rules
  const Module& main() const { return *modules.front(); }
};

}  // namespace af2::dsl
