// Compiles a `ruleset` block to the settings that all rules share.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dsl/compile/compiled_rule.h"
#include "dsl/compile/expressions.h"
#include "dsl/compile/rule_compiler.h"
#include "engine/rule/rule_set.h"

namespace af2::dsl {

/// A `ruleset` block and its file.
struct PlacedRuleSet {
  const RuleSetBlock* block = nullptr;
  const Module* home = nullptr;
};

/// Compiles the settings: first those that rules depend on, then the rest when the rules are known.
class RuleSetCompiler {
 public:
  /// `blocks`: the rule set, preceded by the rule sets that it extends, the most basic first. If it
  /// is empty, all settings have their defaults.
  RuleSetCompiler(CompileContext& context, const Module& main, std::vector<PlacedRuleSet> blocks);

  const SharedSettings& shared() const { return shared_; }
  Parity parity() const { return parity_; }
  /// Kinds of elements that the rules may make; empty: any.
  const std::set<std::string>& kinds() const { return kinds_; }

  /// Codes of findings that the rule set allows.
  const std::set<Code>& allowed() const { return allowed_; }

  /// The place of the clause that says which scores are accepted; no value: there is none.
  std::optional<DiagnosticPlace> acceptancePlace() const;

  /// The definition without its rules. `sizes`: the numbers of corners of the elements that the
  /// rules make.
  RuleSetDefinition finish(const std::set<int>& sizes);

 private:
  struct Found {
    const Setting* setting = nullptr;
    const Module* home = nullptr;
  };

  /// Where `settings_` has a setting of the kind of this one.
  static std::size_t slotOf(const SettingContent& content);
  template <class Content>
  const Content* find(const Module** home = nullptr) const;
  void collect(const PlacedRuleSet& placed);
  void readClasses();
  void readFade();
  void readKinds();
  void readParity();
  void readCounts();
  std::optional<ColumnLimits> columns();
  struct Range {
    int first, last;
  };
  int wholeNumber(const Module& home, const Expr& value, const std::string& what, Range range,
                  const std::string& usual);
  int rowRounds();
  std::optional<int> cleanDepth();
  Finish finish() const;
  void readAllowed(const MetaClause& meta, const Module& home);
  std::vector<double> table(const Expr& expr, const Module& home, const char* what, double least);
  bool hasValues(const Program& program, const Expr& expr, const Module& home, const char* what);
  void checkMetric(const Program& program, const Expr& expr, const Module& home, int corners);
  std::shared_ptr<const AF2ElementMetric> metric(const std::set<int>& sizes);
  std::optional<Program> metricProgram(const Expr& expr, const Module& home, int corners);
  std::shared_ptr<const AF2Acceptance> acceptance();
  std::shared_ptr<const AF2FrontOrder> order();
  std::shared_ptr<const AF2FrontOrder> rows(const RowsSetting& setting, const Module& home);

  CompileContext& context_;
  const Module& main_;
  std::vector<PlacedRuleSet> blocks_;
  std::vector<Found> settings_;  ///< by kind of content; the last one is used
  SharedSettings shared_;
  Parity parity_ = Parity::Any;
  std::set<std::string> kinds_;
  std::set<Code> allowed_;
};

template <class Content>
const Content* RuleSetCompiler::find(const Module** home) const {
  const SettingContent like = Content{};
  const Found& found = settings_[slotOf(like)];
  if (!found.setting) return nullptr;
  if (home) *home = found.home;
  return std::get_if<Content>(&found.setting->content);
}

}  // namespace af2::dsl
