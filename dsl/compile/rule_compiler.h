// Compiles one rule from its syntax tree to its definition.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dsl/compile/compiled_rule.h"
#include "dsl/compile/expressions.h"
#include "dsl/compile/test_compiler.h"

namespace af2::dsl {

/// The settings of a rule set that the compilation of rules needs.
struct SharedSettings {
  int maxLevel = 50;
  std::vector<double> fade;              ///< weight of the preferred corner by level
  const Expr* fadeExpression = nullptr;  ///< null: 1/q
  const Module* fadeHome = nullptr;
  /// MatchFrame::counts
  std::optional<std::array<double, 3>> counts;
};

/// The title with the values of its `{parameters}`. Reports unknown parameters.
std::string filledTitle(ExpressionCompiler& expressions, const Name& title);

/// A number as it appears in titles.
std::string shownNumber(double value);

/// Compiles one rule, once as written and once for each mirror image. Reports faults, and leaves
/// out rules with errors.
class RuleCompiler {
 public:
  RuleCompiler(CompileContext& context, const Module& home, const SharedSettings& settings)
      : context_(context), home_(home), settings_(settings) {}

  using Parameter = RuleParameter;

  /// The title of an instance, and its file.
  struct InstanceTitle {
    Name title;
    const Module* home = nullptr;
  };

  /// `instance`: its title instead of the rule's own. With unknown parameters (type
  /// Any) only types are checked, and nothing is returned.
  std::vector<CompiledRule> compile(const Rule& rule,
                                    const std::map<std::string, Parameter>& parameters,
                                    const InstanceTitle* instance = nullptr);

  /// A property of a compiled rule. The rule may be in another file than the property (`home`).
  std::optional<CompiledProperty> compileProperty(const Property& property, const Module& written,
                                                  const CompiledRule& rule);

 private:
  std::shared_ptr<const RuleDefinition> imageOf(const Rule& rule,
                                                const std::map<std::string, Parameter>& parameters);
  void tellTooMany(const InstanceTitle& title);
  void tellFurtherMirrors(const Rule& rule);
  void compileOne(const Rule& rule, const std::map<std::string, Parameter>& parameters,
                  const InstanceTitle& title, std::vector<CompiledRule>& result);

  CompileContext& context_;
  const Module& home_;
  const SharedSettings& settings_;
};

}  // namespace af2::dsl
