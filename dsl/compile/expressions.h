// From expressions to values: names, types, and the steps that work them out.
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

/// Where an expression stands; says what it may ask about.
enum class ExpressionPlace { Constant, Level, Metric, Acceptance, FrontOrder, Rule, Test };

struct Wanted;

enum class LocalKind { Vertex, NewVertex, Let, Parameter, Broken };

/// A name of a rule, with what it stands for.
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
  std::map<std::string, Span> definedBelow;  ///< names of the rule, wherever they are defined
  std::vector<bool> inChain;                 ///< by matched vertex
  std::vector<Value> corners;                ///< of the element to be measured, in metrics
  std::function<Node()> fade;                ///< weight of the preferred corner
  /// Free angle at a vertex of a test; nothing where its chain is open.
  std::function<std::optional<double>(int)> turnInTest;
  std::string ruleTitle;  ///< for diagnostics

  const Algebra& algebra() const { return algebra_; }
  ProgramBuilder& builder() const { return algebra_.builder(); }
  const Module& module() const { return *module_; }

  /// Goes on with the names and places of another file.
  void readIn(const Module& module) { module_ = &module; }

  /// Any value; where there is none it has been told, and the result is of type Any.
  Value evaluate(const Expr& expr);

  /// A value of one kind, or Any after telling. `what` names the use: "a coordinate".
  Value number(const Expr& expr, const std::string& what);
  Value truth(const Expr& expr, const std::string& what);
  Value point(const Expr& expr);
  Value shape(const Expr& expr);
  /// A number that does not depend on the match or the level.
  std::optional<double> constantNumber(const Expr& expr, const std::string& what);

  /// Tells that a value is of another type than was wanted, perhaps by a certain use ("a metric");
  /// gives Any.
  Value wrongType(const Expr& expr, const Wanted& wanted, const Value& found,
                  const std::string& use = {});

  struct Corner {
    Value preferred;
    std::optional<Value> limiting;
  };
  /// p or p => l, both points.
  Corner corner(const Expr& expr);

  /// Types only, parameters unknown: for definitions that nobody has called yet.
  Value checkBody(const FunctionName& function);

  /// D1, where it is so for every rule that the text stands for: not what one member of a family
  /// makes of it, and once for a rule and its mirror.
  void warnIdle(Span span, std::string message, std::string help);
  /// R1 for codes that there are not in `allow`.
  void checkAllowed(const MetaClause& meta);
  void tell(Code code, Span span, std::string message, std::string label = {}, Help help = {},
            std::vector<DiagnosticNote> notes = {}, std::optional<Severity> severity = {});
  void tell(Diagnostic finding);
  /// What is told, to be completed first.
  Diagnostic finding(Code code, Span span, std::string message, std::string label = {},
                     const Help& help = {}, std::vector<DiagnosticNote> notes = {}) const;
  /// All names that could stand at this place.
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
  Value callUserMetric(const Expr& expr, const AF2ElementMetric& metric);
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
  /// Whether `q` means something here.
  bool hasLevel() const {
    return place_ != ExpressionPlace::Constant && place_ != ExpressionPlace::Test;
  }
  bool isMetricName(const std::string& name) const;
  bool isAllowedHere(const Expr& expr, const Builtin& builtin);
  bool fits(const Value& value, char kind, const Value* firstAlike, const Expr& argument,
            const std::string& usage);
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

/// The whole shape, seen from the base's frame.
ShapeValue reflected(const Algebra& algebra, const ShapeValue& shape);

}  // namespace af2::dsl
