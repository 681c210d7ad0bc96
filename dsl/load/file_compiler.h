// From the syntax trees of a rule file and its imports to a rule set.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "dsl/compile/library.h"
#include "dsl/compile/rule_compiler.h"
#include "dsl/compile/rule_set_compiler.h"
#include "dsl/load/loaded_file.h"
#include "dsl/load/rule_file.h"
#include "dsl/text/words.h"

namespace af2::dsl {

/// Compiles one main file: its rule set, its rules, and the rules that it uses from other files.
class FileCompiler {
 public:
  FileCompiler(CompileContext& context, const Library& library, const LoadOptions& options)
      : context_(context),
        library_(library),
        main_(*library.modules().front()),
        needsRuleSet_(options.needsRuleSet),
        allowed_(options.allowed) {}

  /// Null if there are errors or no rules. Compiled rules and tests are stored in `result`.
  std::shared_ptr<const RuleSet> compile(LoadedFile& result);

 private:
  using Parameters = std::map<std::string, RuleCompiler::Parameter>;

  void compileItems(const Module& module);
  void compileInstance(const Module& module, const Instance& instance);
  void checkTemplate(const Module& module, const Template& item);
  void compileUse(const Module& module, const Use& use);
  void checkTitle(const Module& module, const Use& use, const Name& name);
  Help guessAmong(const std::string& written, const std::vector<std::string>& known,
                  const std::string& what) const {
    return context_.mayGuess() ? helpAmong(written, known, what) : Help();
  }
  const std::vector<CompiledRule>& rulesOf(const Module& library);
  void append(std::vector<CompiledRule> compiled);
  void keepMissing(LoadedFile& result, const std::vector<MissingName>& ofSettings,
                   const std::vector<MissingName>& ofTests);
  void checkKinds(const RuleSetCompiler& settings);
  void compileTests(LoadedFile& result);
  void compileProperty(const Property& property, LoadedFile& result);
  std::set<int> sizesMade() const;
  std::shared_ptr<const RuleSet> ruleSetOf(std::vector<CompiledRule>& rules,
                                           RuleSetDefinition definition);
  bool holdsRule(const Module& module, const std::string& title) const;

  CompileContext& context_;
  const Library& library_;
  const Module& main_;
  bool needsRuleSet_;
  const std::vector<Code>& allowed_;
  std::unique_ptr<RuleSetCompiler> settings_;
  std::vector<CompiledRule> rules_;
  std::map<const Module*, std::vector<CompiledRule>> libraryRules_;
};

}  // namespace af2::dsl
