// From a rule's text to its definition.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dsl/compiled_rule.h"
#include "dsl/expressions.h"

namespace af2::dsl {

/// What the rules of a file share, as far as their compilation asks for it.
struct SharedSettings {
  int maxLevel = 50;
  std::vector<double> fade;              ///< weight of the preferred corner by level
  const Expr* fadeExpression = nullptr;  ///< null: 1/q
  const Module* fadeHome = nullptr;
};

/// Names with known values that a rule is compiled with: of its family, of its template.
using Arguments = std::map<std::string, std::pair<Value, Span>>;

/// `{k}` filled in. Tells what it does not know.
std::string filledTitle(ExpressionCompiler& expressions, const Name& title);

/// A number as titles show it.
std::string shownNumber(double value);

/// Compiles one rule, once as written and once for each mirror. What is wrong is told; a rule with
/// errors is left out.
class RuleCompiler {
 public:
  RuleCompiler(CompileContext& context, const Module& home, const SharedSettings& settings)
      : context_(context), home_(home), settings_(settings) {}

  struct Parameter {
    ConstantName value;
    Span span;
  };

  /// `title`: instead of the rule's own, for instances of templates. With unknown parameters (type
  /// Any) only types are checked, and nothing is returned.
  std::vector<CompiledRule> compile(const Rule& rule,
                                    const std::map<std::string, Parameter>& parameters,
                                    const Name* title = nullptr);

 private:
  void compileOne(const Rule& rule, const std::map<std::string, Parameter>& parameters,
                  const Name& title, std::vector<CompiledRule>& result);

  CompileContext& context_;
  const Module& home_;
  const SharedSettings& settings_;
};

}  // namespace af2::dsl
