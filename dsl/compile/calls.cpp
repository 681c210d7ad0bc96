// Calls of functions in expressions.
#include <algorithm>
#include <cmath>
#include <utility>

#include "dsl/compile/expressions.h"
#include "dsl/compile/type_help.h"
#include "dsl/program/builtins.h"
#include "dsl/text/words.h"
#include "engine/base/turn.h"

namespace af2::dsl {
namespace {

bool isAlike(const Value& a, const Value& b) {
  return a.type == b.type && (a.type != Type::Geometric || std::abs(a.weight - b.weight) < 1e-9);
}

/// The letter for the i-th argument; 0 if there are too many.
char kindOf(std::string_view parameters, std::size_t i) {
  const bool repeats = parameters.ends_with('*');
  const std::size_t fixed = parameters.size() - (repeats ? 1 : 0);
  if (i < fixed) return parameters[i];
  return repeats && fixed > 0 ? parameters[fixed - 1] : '\0';
}

bool isCountRight(std::string_view parameters, std::size_t count) {
  const bool repeats = parameters.ends_with('*');
  const std::size_t fixed = parameters.size() - (repeats ? 1 : 0);
  return repeats ? count >= fixed : count == fixed;
}

/// A number as it is written, perhaps with a sign or in brackets; null if it is anything else.
const Expr* literalIn(const Expr& expr) {
  if (expr.kind == ExprKind::Negate || expr.kind == ExprKind::Paren)
    return expr.parts.size() == 1 ? literalIn(expr.parts[0]) : nullptr;
  return expr.kind == ExprKind::Number ? &expr : nullptr;
}

bool asksTheFront(std::string_view parameters, std::string_view name) {
  return parameters == "w" || parameters == "c" || parameters == "e" || name == "h" ||
         name == "loop_size" || name == "dist_front" || name == "curvature";
}

}  // namespace

bool ExpressionCompiler::isMetricName(const std::string& name) const {
  const auto found = module_->functions.find(name);
  return findBuiltinMetric(name) || (found != module_->functions.end() && found->second.isMetric) ||
         context_.registry.metrics().contains(name);
}

bool ExpressionCompiler::isAllowedHere(const Expr& expr, const Builtin& builtin) {
  if (!asksTheFront(builtin.parameters, builtin.name)) return true;
  const bool isFact = builtin.name == "layer" || builtin.name == "turn" ||
                      builtin.name == "corner" || builtin.name == "count";
  if (place_ == ExpressionPlace::Rule || (place_ == ExpressionPlace::FrontOrder && isFact))
    return true;
  if (place_ == ExpressionPlace::Test && builtin.name == "turn") return true;
  // A def can be called from anywhere, so its body may use everything.
  if (place_ == ExpressionPlace::Constant && !locals.empty()) return true;
  const char* here =
      place_ == ExpressionPlace::Test ? "in a test, which has no mesh around it" : "here";
  tell(Code::NotAvailable, expr.span, "'" + expr.name + "' is not available " + here, "",
       "it depends on the front around a match, so it can be used in rules only");
  return false;
}

bool ExpressionCompiler::fits(const Value& value, char kind, const Value* firstAlike,
                              const Expr& argument, const std::string& usage) {
  if (value.isAny()) return false;
  bool isRight = false;
  switch (kind) {
    case 'n':
      isRight = value.type == Type::Number;
      break;
    case 'a':
      isRight = value.type == Type::Angle;
      break;
    case 'r':
    case 'x':
      isRight = value.type == Type::Number || value.type == Type::Angle;
      break;
    case 'p':
      isRight = value.isPoint();
      break;
    case 'v':
      isRight = value.isVector();
      break;
    case 'g':
      isRight = value.isPoint() || value.isVector();
      break;
    case 'l':
      isRight = value.isPoint() || value.isVector() || value.type == Type::Number ||
                value.type == Type::Angle;
      break;
    case 't':
      isRight = value.type == Type::Truth;
      break;
    case 'e':
      isRight = (value.vertex == 0 || value.vertex == 1) && !value.isNewVertex;
      break;
    case 'w':
    case 'c':
      isRight = value.vertex >= 0 && !value.isNewVertex;
      break;
    default:
      break;
  }
  if (isRight && firstAlike && (kind == 'x' || kind == 'g' || kind == 'l') &&
      !isAlike(*firstAlike, value)) {
    tell(Code::WrongOperands, argument.span, "the arguments of " + usage + " must be of one type",
         "this is " + describe(value) + ", the first is " + describe(*firstAlike));
    return false;
  }
  if (isRight && kind == 'c' && place_ != ExpressionPlace::Test &&
      !(static_cast<std::size_t>(value.vertex) < inChain.size() &&
        inChain[static_cast<std::size_t>(value.vertex)])) {
    tell(Code::NotAvailable, argument.span, "this vertex has no known place on the front",
         "it is not in a chain", "name it in a `front` chain, which fixes its neighbours");
    return false;
  }
  if (isRight) return true;
  if (value.isNewVertex && (kind == 'w' || kind == 'c' || kind == 'e')) {
    tell(Code::NotAvailable, argument.span, "a new vertex is not on the front yet", "",
         usage + " takes a matched vertex");
    return false;
  }
  const bool isWeight =
      value.type == Type::Geometric && std::string("pvgl").find(kind) != std::string::npos;
  if (isWeight) {
    std::string help = "the call is " + usage;
    if (kind == 'v' && value.isPoint())
      help = usage + " takes a vector, such as the difference of two points `b - a`" +
             (usage.starts_with("len") ? "; the distance of two points is dist(p, q)" : "");
    if (kind == 'p' && value.isVector())
      help = usage + " takes a point; add the vector to one, as in `a + (0, 1)`";
    if (!value.isPoint() && !value.isVector()) {
      wrongType(argument, wantedBy(kind), value);
      return false;
    }
    tell(Code::WrongType, argument.span, "this is not " + wantedBy(kind).words,
         "this is " + describe(value), help);
    return false;
  }
  const std::string way = wayToType(wantedBy(kind).kind, value);
  tell(Code::WrongType, argument.span, "this is not " + wantedBy(kind).words,
       "this is " + describe(value), (way.empty() ? "" : way + "; ") + "the call is " + usage);
  return false;
}

/// A bare number is in radians. A literal of more than a full turn was meant in degrees.
void ExpressionCompiler::tellOfDegrees(const Expr& argument) {
  const Expr* literal = literalIn(argument);
  if (!literal || std::abs(literal->number) <= kFullTurn) return;
  tell(Code::MissingDegrees, literal->span, "this angle is more than a full turn",
       "a number without a unit is in radians",
       Help("write `" + literal->name + "deg` for an angle in degrees",
            {Remedy::Where::Behind, "deg"}));
}

void ExpressionCompiler::tellOfCount(const Expr& expr, const std::string& usage) {
  tell(Code::ArgumentCount, expr.span,
       "'" + expr.name + "' is called with " + std::to_string(expr.parts.size()) +
           (expr.parts.size() == 1 ? " argument" : " arguments"),
       "", "the call is " + usage);
}

Value ExpressionCompiler::callBuiltin(const Expr& expr, const Builtin& builtin) {
  const std::string usage(builtin.usage);
  if (!isAllowedHere(expr, builtin)) return {};
  const bool needsCounts = builtin.name == "count" || builtin.name == "spoke";
  if (needsCounts && !algebra_.frame().counts && place_ != ExpressionPlace::Constant) {
    tell(Code::MissingCounts, expr.span, "'" + expr.name + "' needs the counts of the rule set", "",
         "add `counts 130deg, 235deg, 315deg;` to the rule set; `corner(v)` works without");
    return {};
  }
  if (!isCountRight(builtin.parameters, expr.parts.size())) {
    tellOfCount(expr, usage);
    return {};
  }
  std::vector<Value> arguments;
  bool isRight = true;
  for (const Expr& part : expr.parts) arguments.push_back(evaluate(part));
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const char kind = kindOf(builtin.parameters, i);
    const bool isLikeFirst =
        i > 0 && !arguments[0].isAny() && kind == kindOf(builtin.parameters, 0);
    isRight =
        fits(arguments[i], kind, isLikeFirst ? &arguments[0] : nullptr, expr.parts[i], usage) &&
        isRight;
  }
  if (!isRight) return {};
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (kindOf(builtin.parameters, i) == 'r' && arguments[i].type == Type::Number)
      tellOfDegrees(expr.parts[i]);
  if (place_ == ExpressionPlace::Test && builtin.name == "turn") {
    const auto turn = turnInTest(arguments[0].vertex);
    if (turn) return algebra_.angle(*turn);
    tell(Code::NotAvailable, expr.span, "this vertex has no turn", "its chain is open here",
         "a turn needs a neighbour on both sides");
    return {};
  }
  return needValue(expr, builtin.make(algebra_, arguments));
}

Value ExpressionCompiler::inlined(const Expr& callSite, const FunctionName& function,
                                  std::vector<Value> arguments) {
  constexpr std::size_t kDeepest = 60;
  if (function.isBroken || calls_.size() > kDeepest) return {};
  for (const Value& argument : arguments)
    if (argument.isAny()) return {};
  std::map<std::string, Local> outer;
  std::swap(outer, locals);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    Local local;
    local.value = std::move(arguments[i]);
    local.kind = LocalKind::Parameter;
    locals[(*function.parameters)[i].text] = std::move(local);
  }
  calls_.push_back({callSite.span, module_, callSite.name});
  const Module* home = std::exchange(module_, function.home);
  const std::vector<Value> outerCorners = std::exchange(corners, {});
  Value result = evaluate(*function.body);
  corners = outerCorners;
  module_ = home;
  calls_.pop_back();
  std::swap(outer, locals);
  return result;
}

Value ExpressionCompiler::callFunction(const Expr& expr, const FunctionName& function) {
  if (!function.body) return function.external ? callExtern(expr, function) : Value{};
  std::vector<Value> arguments;
  for (const Expr& part : expr.parts) arguments.push_back(evaluate(part));
  const std::size_t wanted = function.parameters->size();
  if (function.isMetric && arguments.size() + corners.size() == wanted)
    arguments.insert(arguments.end(), corners.begin(), corners.end());
  if (arguments.size() != wanted) {
    std::string usage = expr.name + "(";
    for (const Name& p : *function.parameters) usage += (usage.back() == '(' ? "" : ", ") + p.text;
    usage += ")";
    const bool isPartial = function.isMetric && !corners.empty();
    if (isPartial)
      tell(Code::ArgumentCount, expr.span,
           "the metric '" + expr.name + "' does not measure elements of " +
               std::to_string(corners.size()) + " corners",
           "", "it is defined as " + usage + "; its last three or four parameters are the corners");
    else
      tellOfCount(expr, usage);
    return {};
  }
  Value result = inlined(expr, function, std::move(arguments));
  if (function.isMetric && !result.isAny() && result.type != Type::Number)
    return wrongType(expr, wantedNumber(), result, "a metric");
  return result;
}

Value ExpressionCompiler::callMetric(const Expr& expr, const BuiltinMetric& metric) {
  const std::string usage(metric.usage);
  std::vector<Value> values;
  for (const Expr& part : expr.parts) values.push_back(evaluate(part));
  const auto weights = static_cast<std::size_t>(metric.weights);
  std::vector<Value> measured = corners;
  if (values.size() == weights + 3 || values.size() == weights + 4)
    measured.assign(values.begin() + metric.weights, values.end());
  else if (values.size() != weights || corners.empty()) {
    tell(Code::ArgumentCount, expr.span,
         "'" + expr.name + "' is called with " + std::to_string(expr.parts.size()) +
             (expr.parts.size() == 1 ? " argument" : " arguments"),
         "",
         corners.empty()
             ? "outside of a rule set a metric takes its weights and three or four corners"
             : "the call is " + usage);
    return {};
  }
  bool isRight = true;
  for (std::size_t i = 0; i < values.size(); ++i)
    isRight = fits(values[i], i < weights ? 'n' : 'p', nullptr, expr.parts[i], usage) && isRight;
  if (!isRight) return {};
  values.resize(weights);
  return metric.make(algebra_, values, measured);
}

const FunctionName* ExpressionCompiler::findFunction(const Expr& call, bool& isTold) {
  isTold = false;
  const Module* home = module_;
  if (!call.qualifier.empty()) {
    const auto library = module_->imports.find(call.qualifier);
    isTold = true;
    if (library == module_->imports.end()) {
      evaluateImported(call);
      return nullptr;
    }
    home = library->second;
    if (!home) return nullptr;
  }
  const auto found = home->functions.find(call.name);
  if (found != home->functions.end()) return &found->second;
  if (!call.qualifier.empty()) {
    std::vector<std::string> known;
    for (const auto& [name, f] : home->functions) known.push_back(name);
    tell(Code::UnknownName, call.span,
         "'" + call.qualifier + "' has no function '" + call.name + "'", "",
         didYouMean(call.name, known));
  }
  return nullptr;
}

Value ExpressionCompiler::evaluateCall(const Expr& expr) {
  bool isTold = false;
  if (const FunctionName* function = findFunction(expr, isTold)) {
    if (!isBelow(expr, function->home, function->span)) return callFunction(expr, *function);
    for (const Expr& part : expr.parts) evaluate(part);
    return usedTooEarly(expr, function->span);
  }
  if (isTold) return {};
  if (const Builtin* builtin = findBuiltin(expr.name)) return callBuiltin(expr, *builtin);
  if (const BuiltinMetric* metric = findBuiltinMetric(expr.name)) return callMetric(expr, *metric);
  if (expr.name == "inside") return inside(expr);
  if (isShapeFunction(expr.name)) return callShape(expr);
  const Registry& registry = context_.registry;
  if (const auto f = registry.functions().find(expr.name); f != registry.functions().end())
    return callUserFunction(expr, f->second);
  if (const auto m = registry.metrics().find(expr.name); m != registry.metrics().end())
    return callUserMetric(expr, m->second);
  if (const auto s = registry.shapes().find(expr.name); s != registry.shapes().end())
    return callUserShape(expr, s->second);
  for (const Expr& part : expr.parts) evaluate(part);
  return unknownName(expr, true);
}

}  // namespace af2::dsl
