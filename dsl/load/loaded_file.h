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
  /// Names that the rules use and that no program has registered, once each. If `settings` of the
  /// rule set use one, all rules depend on it.
  std::vector<MissingName> missing;
  std::set<Code> allowed;  ///< codes that the rule set allows, for all rules
  const Module& main() const { return *modules.front(); }
};

/// Why the rules cannot be evaluated, in one line: "'egg' is declared, but nothing implements it;
/// --plugin FILE loads a library that does". Empty if they can be.
std::string missingText(const LoadedFile& file);

}  // namespace af2::dsl
