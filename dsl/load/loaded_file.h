// The source of a rule set: its files, rules and tests.
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
  std::vector<CompiledRule> rules;  ///< the rules of `soundRules` first, in the same order
  /// The rule set without rules that have errors, so that further checks can report all mistakes in
  /// one run. Null if there is no rule set, or no rule without errors.
  std::shared_ptr<const RuleSet> soundRules;
  std::vector<CompiledTest> tests;  ///< the tests of the file itself that have no errors
  std::vector<CompiledProperty> properties;
  std::set<Code> allowed;  ///< codes that the rule set allows, for all rules
  const Module& main() const { return *modules.front(); }
};

}  // namespace af2::dsl
