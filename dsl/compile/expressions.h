// Compiles expressions: resolves names, checks types, and makes the steps that compute values.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dsl/compile/compile_context.h"
#include "dsl/program/builtins.h"
#include "dsl/program/values.h"
#include "dsl/syntax/ast.h"

namespace af2::dsl {

/// The place of an expression, which determines what it may use.
enum class ExpressionPlace { Constant, Level, Metric, Acceptance, FrontOrder, Rule, Test };

struct Wanted;

enum class LocalKind { Vertex, NewVertex, Let, Parameter, Broken };

/// A name of a rule, with its value.
struct Local {
  Value value;
  Span span;
  LocalKind kind = LocalKind::Let;
  bool isUsed = false;
};

class ExpressionCompiler {
 public:
  ExpressionCompiler(CompileContext& context, const Module& module, ExpressionPlace place,
                     Algebra algebra)
      : context_(context), module_(&module), place_(place), algebra_(algebra) {}

  std::map<std::string, Local> locals;
  std::map<std::string, Span> definedBelow;  ///< names that the rule defines, above or below
  std::vector<bool> inChain;                 ///< by matched vertex
  std::vector<Value> corners;                ///< in metrics: the corners of the measured element
  std::function<Node()> fade;                ///< weight of the preferred corner
  /// Free angle at a vertex of a test; nothing at an end of a chain.
  std::function<std::optional<double>(int)> turnInTest;
  std::string ruleTitle;  ///< for diagnostics

  const Algebra& algebra() const { return algebra_; }
  ProgramBuilder& builder() const { return algebra_.builder(); }
  const Module& module() const { return *module_; }

  /// Continues with the names and places of another file.
  void readIn(const Module& module) { module_ = &module; }

  /// A value of any type. If there is none, the error has been reported and the result has type
  /// Any.
  Value evaluate(const Expr& expr);

  /// A value of one type, or Any after an error. `what` names the use in messages: "a coordinate".
  Value number(const Expr& expr, const std::string& what);
  Value truth(const Expr& expr, const std::string& what);
  Value point(const Expr& expr);
  Value shape(const Expr& expr);
  /// A number that does not depend on the match or the level.
  std::optional<double> constantNumber(const Expr& expr, const std::string& what);

  /// Reports that a value has the wrong type, optionally for a certain use ("a metric"). Returns
  /// Any.
  Value wrongType(const Expr& expr, const Wanted& wanted, const Value& found,
                  const std::string& use = {});

  struct Corner {
    Value preferred;
    std::optional<Value> limiting;
  };
  /// A corner `p` or `p => l`; both must be points.
  Corner corner(const Expr& expr);

  /// Checks only the types, with unknown parameters, for definitions that have not been called yet.
  Value checkBody(const FunctionName& function);

  /// Reports D1 once for a rule and its mirror image. In a family it is not reported, because it
  /// may hold for one member only.
  void warnIdle(Span span, std::string message, std::string help);
  /// Reports R1 for unknown codes in `allow`.
  void checkAllowed(const MetaClause& meta);
  void tell(Code code, Span span, std::string message, std::string label = {}, Help help = {},
            std::vector<DiagnosticNote> notes = {}, std::optional<Severity> severity = {});
  void tell(Diagnostic finding);
  /// A diagnostic that the caller completes before it is reported.
  Diagnostic finding(Code code, Span span, std::string message, std::string label = {},
                     const Help& help = {}, std::vector<DiagnosticNote> notes = {}) const;
  /// All names that are valid at this place.
  std::vector<std::string> namesInScope() const;

 private:
  struct Call {
    Span span;
    const Module* module;
    std::string name;
  };

  Value evaluateName(const Expr& expr);
  Value evaluateImported(const Expr& expr);
  Value evaluateTuple(const Expr& expr);
  Value evaluateMember(const Expr& expr);
  Value evaluateUnary(const Expr& expr);
  Value evaluateBinary(const Expr& expr);
  Value evaluateLogic(const Expr& expr);
  Value evaluateComparison(const Expr& expr);
  Value evaluateRange(const Expr& expr);
  Value evaluateIf(const Expr& expr);
  Value evaluateCall(const Expr& expr);
  Value callBuiltin(const Expr& expr, const Builtin& builtin);
  Value callFunction(const Expr& expr, const FunctionName& function);
  Value callMetric(const Expr& expr, const BuiltinMetric& metric);
  Value callExtern(const Expr& expr, const FunctionName& declared);
  Value callUserMetric(const Expr& expr, const std::shared_ptr<const AF2ElementMetric>& metric);
  Value callUserFunction(const Expr& expr, const std::shared_ptr<const UserFunction>& function);
  Value callShape(const Expr& expr);
  Value callUserShape(const Expr& expr, const std::shared_ptr<const UserShape>& shape);
  Value inside(const Expr& expr);
  bool isGrownUser(const Expr& expr, const ShapeValue& shape);
  Value polyShape(const Expr& expr);
  Value shapeChain(const Expr& expr);
  Value shapeOf(ShapeKind kind, const Value& first, const Value& second);
  Value fadeShapes(const Expr& expr);
  void tellNoFade(const Expr& expr);
  Value add(const Expr& expr, const Value& a, const Value& b);
  Value multiply(const Expr& expr, const Value& a, const Value& b);
  Value divide(const Expr& expr, const Value& a, const Value& b);
  Value power(const Expr& expr, const Value& a, const Value& b);
  Value inlined(const Expr& callSite, const FunctionName& function, std::vector<Value> arguments);
  NodePair fadedPoint(const Expr& expr);
  /// Whether `q` has a value here.
  bool hasLevel() const {
    return place_ != ExpressionPlace::Constant && place_ != ExpressionPlace::Test;
  }
  bool isMetricName(const std::string& name) const;
  bool isAllowedHere(const Expr& expr, const Builtin& builtin);
  bool fits(const Value& value, char kind, const Value* firstAlike, const Expr& argument,
            const std::string& usage);
  void tellOfDegrees(const Expr& argument);
  void tellOfCount(const Expr& expr, const std::string& usage);
  Value needValue(
      const Expr& expr, Value value,
      const char* cause = "a division by zero, a root of a negative number or the like");
  Value wrongOperands(const Expr& expr, const Value& a, const Value& b, std::string help);
  Value unknownName(const Expr& expr, bool isFunction);
  bool isBelow(const Expr& expr, const Module* home, Span definition);
  Value usedTooEarly(const Expr& expr, Span definition);
  Value fromConstant(const ConstantName& constant) const;
  const FunctionName* findFunction(const Expr& call, bool& isTold);

  CompileContext& context_;
  const Module* module_;
  ExpressionPlace place_;
  Algebra algebra_;
  std::vector<Call> calls_;
};

/// The whole shape, in the frame of the base edge.
ShapeValue reflected(const Algebra& algebra, const ShapeValue& shape);

}  // namespace af2::dsl
