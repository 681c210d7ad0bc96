#include "dsl/expressions.h"
#include "dsl/allowed_codes.h"
#include "dsl/code_explanations.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dsl/builtins.h"
#include "dsl/type_help.h"
#include "dsl/words.h"

namespace af2::dsl {

void ExpressionCompiler::warnIdle(Span span, std::string message, std::string help) {
  const auto isParameter = [](const auto& entry) {
    return entry.second.kind == LocalKind::Parameter;
  };
  if (algebra_.frame().mirrored || std::ranges::any_of(locals, isParameter)) return;
  tell("D1", span, std::move(message), "", std::move(help), Severity::Warning);
}

void ExpressionCompiler::tell(const char* code, Span span, std::string message, std::string label,
                              Help help, Severity severity, std::vector<DiagnosticNote> notes) {
  if (!context_.diagnostics.takes(severity)) return;
  Diagnostic d;
  d.severity = severity;
  d.code = code;
  d.message = std::move(message);
  d.label = std::move(label);
  setHelp(d, module_->source, span, help);
  d.notes = std::move(notes);
  d.rule = ruleTitle;
  if (calls_.empty()) {
    d.place = placeOf(module_->source, span);
  } else {
    // Inside a definition the fault lies with what was handed over; it is told at the call.
    d.place = placeOf(calls_.front().module->source, calls_.front().span);
    d.notes.push_back({"this is in the definition of '" + calls_.back().name + "'",
                       placeOf(module_->source, span)});
  }
  context_.diagnostics.add(std::move(d));
}

void ExpressionCompiler::checkAllowed(const MetaClause& meta) {
  for (const MetaEntry& entry : meta.entries)
    for (const std::string& code : allowedBy({{entry}})) {
      if (findCodeExplanation(code)) continue;
      std::vector<std::string> known;
      for (const CodeExplanation& e : codeExplanations()) known.push_back(e.code);
      const Help guess = didYouMean(code, known);
      tell("R1", entry.value.span, "there is no code '" + code + "'", "",
           guess.empty() ? "codes stand in what is told, as in `allow \"Z1, M1\";`" : guess);
    }
}

std::vector<std::string> ExpressionCompiler::namesInScope() const {
  std::vector<std::string> names;
  for (const auto& [name, local] : locals)
    if (local.kind != LocalKind::Broken) names.push_back(name);
  for (const auto& [name, constant] : module_->constants) names.push_back(name);
  if (hasLevel()) names.push_back("q");
  if (place_ == ExpressionPlace::Acceptance) names.push_back("score");
  return names;
}

Value ExpressionCompiler::wrongType(const Expr& expr, const std::string& wanted,
                                    const Value& found) {
  if (found.isAny()) return {};
  const bool isWeight = found.type == Type::Geometric && !found.isPoint() && !found.isVector();
  if (isWeight) {
    tell("A1", expr.span, "this is not " + wanted,
         "weights add up to " +
             describe(found).substr(std::string("a sum of points of weight ").size()) +
             "; a point needs 1, a vector 0",
         "let the weights of the points add up to 1, as in `2*d - a`, or use mid, lerp, centroid");
    return {};
  }
  const bool wantsPoint = wanted == "a point" || wanted == "a vector";
  tell(wantsPoint && found.type == Type::Geometric ? "A1" : "Y1", expr.span,
       "this is not " + wanted, "this is " + describe(found), wayToType(wanted, found));
  return {};
}

Value ExpressionCompiler::needValue(const Expr& expr, Value value) {
  const auto isNothing = [&](Node node) {
    const auto constant = node >= 0 ? builder().constantValue(node) : std::nullopt;
    return constant && std::isnan(*constant);
  };
  const bool isBroken =
      value.type == Type::Geometric
          ? isNothing(value.at.x) || isNothing(value.at.y)
          : !value.isAny() && value.type != Type::Shape && isNothing(value.number);
  if (!isBroken) return value;
  tell("Y4", expr.span, "this never has a value",
       "a division by zero, a root of a negative number or the like");
  return {};
}

Value ExpressionCompiler::number(const Expr& expr, const std::string& what) {
  const Value value = evaluate(expr);
  if (value.isAny() || value.type == Type::Number) return value;
  return wrongType(expr, "a number" + (what.empty() ? "" : ", as " + what + " must be"), value);
}

Value ExpressionCompiler::truth(const Expr& expr, const std::string& what) {
  const Value value = evaluate(expr);
  if (value.isAny() || value.type == Type::Truth) return value;
  wrongType(expr, "a condition, as " + what + " must be", value);
  return {};
}

Value ExpressionCompiler::point(const Expr& expr, const std::string& what) {
  const Value value = evaluate(expr);
  if (value.isAny() || value.isPoint()) return value;
  (void)what;
  return wrongType(expr, "a point", value);
}

std::optional<double> ExpressionCompiler::constantNumber(const Expr& expr,
                                                         const std::string& what) {
  if (expr.isMissing()) return std::nullopt;
  const Value value = number(expr, what);
  if (value.isAny()) return std::nullopt;
  const auto constant = builder().constantValue(value.number);
  if (!constant)
    tell("Y3", expr.span, what + " must be a constant", "this depends on the match or on q",
         "use numbers, constants and parameters only");
  return constant;
}

Value ExpressionCompiler::fromConstant(const ConstantName& constant) const {
  switch (constant.type) {
    case Type::Number:
      return algebra_.number(constant.number);
    case Type::Angle:
      return algebra_.angle(constant.number);
    case Type::Truth:
      return algebra_.truth(constant.number != 0);
    case Type::Geometric:
      return algebra_.vector({builder().constant(constant.x), builder().constant(constant.y)});
    default:
      return {};
  }
}

/// Everything is defined above its use, in the order of the text.
bool ExpressionCompiler::isBelow(const Expr& expr, const Module* home, Span definition) {
  return home == module_ && expr.qualifier.empty() && definition.begin > expr.span.begin;
}

Value ExpressionCompiler::usedTooEarly(const Expr& expr, Span definition) {
  const bool isItself =
      module_->source.lineOf(definition.begin) == module_->source.lineOf(expr.span.begin) &&
      definition.begin < expr.span.begin;
  tell("R1", expr.span,
       isItself ? "'" + expr.name + "' is defined in terms of itself"
                : "'" + expr.name + "' is used before it is defined",
       "", isItself ? "definitions cannot be recursive" : "move its definition up", Severity::Error,
       {{"defined here", placeOf(module_->source, definition)}});
  return {};
}

Value ExpressionCompiler::unknownName(const Expr& expr, bool isFunction) {
  if (module_->brokenNames.contains(expr.name) || module_->hasBrokenImport) return {};
  if (context_.diagnostics.isFull()) {  // guessing what was meant would take its time for each
    tell("R1", expr.span, "there is no '" + expr.name + "' here");
    return {};
  }
  if (const auto below = definedBelow.find(expr.name);
      !isFunction && calls_.empty() && below != definedBelow.end())
    return usedTooEarly(expr, below->second);
  // Defined further down is the commonest slip after a typing error.
  for (const Item& item : module_->parsed.file.items) {
    const Name* name = nullptr;
    if (const auto* c = std::get_if<Constant>(&item.content))
      name = isFunction ? nullptr : &c->name;
    if (const auto* f = std::get_if<Function>(&item.content))
      name = isFunction ? &f->name : nullptr;
    if (const auto* m = std::get_if<Metric>(&item.content)) name = isFunction ? &m->name : nullptr;
    if (name && name->text == expr.name) return usedTooEarly(expr, name->span);
  }
  std::vector<std::string> known = isFunction ? builtinNames() : namesInScope();
  if (isFunction) {
    for (const auto& [name, function] : module_->functions) known.push_back(name);
    for (const auto& [name, f] : context_.registry.functions()) known.push_back(name);
  }
  Help help = habitOf(expr.name);
  if (help.empty()) help = didYouMean(expr.name, known);
  if (isFunction && help.empty() &&
      (locals.contains(expr.name) || module_->constants.contains(expr.name)))
    help = "'" + expr.name + "' is a value; it cannot be called";
  if (!isFunction && help.empty() &&
      (isBuiltin(expr.name) || module_->functions.contains(expr.name)))
    help = "'" + expr.name + "' is a function; call it with arguments in parentheses";
  if (help.empty() && !isFunction) {
    std::string list;
    for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
    if (!list.empty() && list.size() < 120) help = "known here: " + list;
  }
  tell("R1", expr.span,
       std::string(isFunction ? "there is no function '" : "there is no '") + expr.name + "'" +
           (isFunction ? "" : " here"),
       "", help);
  if (!isFunction && place_ == ExpressionPlace::Rule && calls_.empty()) {
    Local broken;  // told once for each rule
    broken.kind = LocalKind::Broken;
    locals.emplace(expr.name, std::move(broken));
  }
  return {};
}

Value ExpressionCompiler::evaluateName(const Expr& expr) {
  const auto local = locals.find(expr.name);
  if (local != locals.end()) {
    local->second.isUsed = true;
    return local->second.value;
  }
  if (expr.name == "q" || expr.name == "class") {
    if (!hasLevel()) {
      tell("R1", expr.span, "there is no quality level here", "",
           "'" + expr.name + "' means something in rules and rule sets only");
      return {};
    }
    return algebra_.scalar(Type::Number, builder().make(Op::Level, std::initializer_list<Node>{}));
  }
  if (expr.name == "score" && place_ == ExpressionPlace::Acceptance)
    return algebra_.scalar(Type::Number,
                           builder().make(Op::Input, std::initializer_list<Node>{}, 0));
  const auto constant = module_->constants.find(expr.name);
  if (constant != module_->constants.end()) {
    if (isBelow(expr, constant->second.home, constant->second.span))
      return usedTooEarly(expr, constant->second.span);
    return fromConstant(constant->second);
  }
  if (!corners.empty() && isMetricName(expr.name)) return evaluateCall(expr);
  if (place_ == ExpressionPlace::Rule || place_ == ExpressionPlace::FrontOrder) {
    const std::vector<std::string> bands{"end", "side", "corner", "reversal"};
    const auto band = std::find(bands.begin(), bands.end(), expr.name);
    if (band != bands.end()) return algebra_.number(static_cast<double>(band - bands.begin()) + 1);
  }
  return unknownName(expr, false);
}

Value ExpressionCompiler::evaluateImported(const Expr& expr) {
  const auto library = module_->imports.find(expr.qualifier);
  if (library == module_->imports.end()) {
    if (module_->brokenNames.contains(expr.qualifier)) return {};
    std::vector<std::string> known;
    for (const auto& [name, m] : module_->imports) known.push_back(name);
    const bool isValue =
        locals.contains(expr.qualifier) || module_->constants.contains(expr.qualifier);
    tell("R1", expr.span,
         isValue ? "'" + expr.qualifier + "' has no part '" + expr.name + "'"
                 : "nothing is imported as '" + expr.qualifier + "'",
         "",
         isValue ? "points and vectors have the parts x and y" : didYouMean(expr.qualifier, known));
    return {};
  }
  if (!library->second) return {};
  const auto constant = library->second->constants.find(expr.name);
  if (constant != library->second->constants.end()) return fromConstant(constant->second);
  const auto metric = library->second->functions.find(expr.name);
  if (metric != library->second->functions.end() && metric->second.isMetric && !corners.empty())
    return callFunction(expr, metric->second);
  std::vector<std::string> known;
  for (const auto& [name, c] : library->second->constants) known.push_back(name);
  tell("R1", expr.span, "'" + expr.qualifier + "' has no constant '" + expr.name + "'", "",
       didYouMean(expr.name, known));
  return {};
}

Value ExpressionCompiler::evaluateTuple(const Expr& expr) {
  if (expr.parts.size() != 2) {
    tell("Y1", expr.span, "a vector has two coordinates",
         std::to_string(expr.parts.size()) + " are given", "write (x, y)");
    return {};
  }
  const Value x = number(expr.parts[0], "a coordinate"), y = number(expr.parts[1], "a coordinate");
  if (x.isAny() || y.isAny()) return {};
  return algebra_.vector({x.number, y.number});
}

Value ExpressionCompiler::evaluateMember(const Expr& expr) {
  const Value whole = evaluate(expr.parts[0]);
  if (whole.isAny()) return {};
  if (expr.name != "x" && expr.name != "y") {
    tell("R1", expr.span, "there is no part '" + expr.name + "'", "",
         "points and vectors have the parts x and y");
    return {};
  }
  if (whole.type != Type::Geometric) return wrongType(expr.parts[0], "a point or vector", whole);
  if (!whole.isPoint() && !whole.isVector())
    return wrongType(expr.parts[0], "a point or vector", whole);
  return algebra_.scalar(Type::Number, expr.name == "x" ? whole.at.x : whole.at.y);
}

Value ExpressionCompiler::evaluateUnary(const Expr& expr) {
  if (expr.kind == ExprKind::Not) {
    const Value v = truth(expr.parts[0], "what follows `not`");
    return v.isAny() ? v : algebra_.scalar(Type::Truth, builder().make(Op::Not, {v.number}));
  }
  const Value v = evaluate(expr.parts[0]);
  if (v.isAny()) return {};
  if (v.type == Type::Geometric)
    return algebra_.geometric({builder().negate(v.at.x), builder().negate(v.at.y)}, -v.weight);
  if (v.type == Type::Number || v.type == Type::Angle)
    return algebra_.scalar(v.type, builder().negate(v.number));
  return wrongType(expr.parts[0], "a number, angle, point or vector", v);
}

Value ExpressionCompiler::wrongOperands(const Expr& expr, const Value& a, const Value& b,
                                        std::string help) {
  tell("Y2", expr.span,
       "'" + expr.name + "' does not work on " + describe(a) + " and " + describe(b), "",
       std::move(help));
  return {};
}

Value ExpressionCompiler::add(const Expr& expr, const Value& a, const Value& b) {
  const bool isSum = expr.name == "+";
  if (a.type != b.type) {
    std::string help;
    if (a.type == Type::Angle || b.type == Type::Angle)
      help = "an angle is written with its unit, as in 60deg";
    else if (a.type == Type::Geometric || b.type == Type::Geometric)
      help = "a vector is written (x, y); the coordinates of a point are p.x and p.y";
    return wrongOperands(expr, a, b, help);
  }
  if (a.type == Type::Geometric)
    return algebra_.geometric(isSum ? algebra_.add(a.at, b.at) : algebra_.subtract(a.at, b.at),
                              isSum ? a.weight + b.weight : a.weight - b.weight);
  if (a.type == Type::Number || a.type == Type::Angle)
    return algebra_.scalar(a.type,
                           builder().make(isSum ? Op::Add : Op::Subtract, {a.number, b.number}));
  if (a.type == Type::Shape && !isSum) return shapeOf(ShapeKind::Difference, a, b);
  return wrongOperands(expr, a, b,
                       a.type == Type::Shape ? "shapes are joined by `|`, `&` and `-`"
                                             : "conditions are joined by `and`, `or`");
}

Value ExpressionCompiler::multiply(const Expr& expr, const Value& a, const Value& b) {
  if (b.type == Type::Geometric && a.type == Type::Number) {
    const auto constant = builder().constantValue(a.number);
    if (!b.isVector() && !constant) {
      tell("A1", expr.span, "the weight of a point must be a constant",
           "this weight depends on the match or on q",
           "use lerp(p, q, t) to move from p to q by a share that varies");
      return {};
    }
    return algebra_.geometric(algebra_.scale(a.number, b.at),
                              b.isVector() ? 0 : *constant * b.weight);
  }
  if (a.type == Type::Geometric && b.type == Type::Number) return multiply(expr, b, a);
  if (a.type == Type::Geometric && b.type == Type::Geometric)
    return wrongOperands(expr, a, b, "use dot(u, v) or cross(u, v)");
  const bool isAngle = a.type == Type::Angle || b.type == Type::Angle;
  const auto isScalar = [](const Value& v) {
    return v.type == Type::Number || v.type == Type::Angle;
  };
  if (!isScalar(a) || !isScalar(b) || (a.type == Type::Angle && b.type == Type::Angle))
    return wrongOperands(expr, a, b, "");
  return algebra_.scalar(isAngle ? Type::Angle : Type::Number,
                         builder().multiply(a.number, b.number));
}

Value ExpressionCompiler::divide(const Expr& expr, const Value& a, const Value& b) {
  if (a.type == Type::Geometric && b.type == Type::Number) {
    const auto constant = builder().constantValue(b.number);
    if (!a.isVector() && !constant) {
      tell("A1", expr.span, "the weight of a point must be a constant",
           "this weight depends on the match or on q",
           "use lerp(p, q, t) to move from p to q by a share that varies");
      return {};
    }
    const NodePair at{builder().divide(a.at.x, b.number), builder().divide(a.at.y, b.number)};
    return needValue(expr, algebra_.geometric(at, a.isVector() ? 0 : a.weight / *constant));
  }
  if (a.type == Type::Angle && b.type == Type::Angle)
    return needValue(expr, algebra_.scalar(Type::Number, builder().divide(a.number, b.number)));
  if ((a.type == Type::Number || a.type == Type::Angle) && b.type == Type::Number)
    return needValue(expr, algebra_.scalar(a.type, builder().divide(a.number, b.number)));
  return wrongOperands(expr, a, b, "");
}

Value ExpressionCompiler::power(const Expr& expr, const Value& a, const Value& b) {
  if (a.type != Type::Number || b.type != Type::Number) return wrongOperands(expr, a, b, "");
  return needValue(expr,
                   algebra_.scalar(Type::Number, builder().make(Op::Power, {a.number, b.number})));
}

Value ExpressionCompiler::evaluateLogic(const Expr& expr) {
  const std::string what = "what stands beside `" + expr.name + "`";
  const Value a = truth(expr.parts[0], what), b = truth(expr.parts[1], what);
  if (a.isAny() || b.isAny()) return {};
  return algebra_.scalar(
      Type::Truth, builder().make(expr.name == "and" ? Op::And : Op::Or, {a.number, b.number}));
}

Value ExpressionCompiler::evaluateComparison(const Expr& expr) {
  const Value a = evaluate(expr.parts[0]), b = evaluate(expr.parts[1]);
  if (a.isAny() || b.isAny()) return {};
  const bool isEquality = expr.name == "==" || expr.name == "!=";
  if (a.type == Type::Geometric && b.type == Type::Geometric && isEquality) {
    if (a.isPoint() != b.isPoint() || a.isVector() != b.isVector())
      return wrongOperands(expr, a, b, "");
    const Node same = builder().make(Op::And, {builder().make(Op::Equal, {a.at.x, b.at.x}),
                                               builder().make(Op::Equal, {a.at.y, b.at.y})});
    return algebra_.scalar(Type::Truth, expr.name == "==" ? same : builder().make(Op::Not, {same}));
  }
  const bool isComparable =
      a.type == Type::Number || a.type == Type::Angle || (a.type == Type::Truth && isEquality);
  if (a.type != b.type || !isComparable) {
    const bool mixesAngle = a.type == Type::Angle || b.type == Type::Angle;
    return wrongOperands(expr, a, b,
                         mixesAngle ? "an angle is compared with an angle, as in 60deg" : "");
  }
  const Node l = a.number, r = b.number;
  Node result;
  if (expr.name == "<")
    result = builder().make(Op::Less, {l, r});
  else if (expr.name == "<=")
    result = builder().make(Op::LessEqual, {l, r});
  else if (expr.name == ">")
    result = builder().make(Op::Less, {r, l});
  else if (expr.name == ">=")
    result = builder().make(Op::LessEqual, {r, l});
  else
    result = builder().make(Op::Equal, {l, r});
  if (expr.name == "!=") result = builder().make(Op::Not, {result});
  return algebra_.scalar(Type::Truth, result);
}

Value ExpressionCompiler::evaluateRange(const Expr& expr) {
  const Value x = evaluate(expr.parts[0]), low = evaluate(expr.parts[1]),
              high = evaluate(expr.parts[2]);
  if (x.isAny() || low.isAny() || high.isAny()) return {};
  const bool isScalar = x.type == Type::Number || x.type == Type::Angle;
  if (!isScalar) return wrongType(expr.parts[0], "a number or an angle", x);
  if (low.type != x.type)
    return wrongType(expr.parts[1], x.type == Type::Angle ? "an angle" : "a number", low);
  if (high.type != x.type)
    return wrongType(expr.parts[2], x.type == Type::Angle ? "an angle" : "a number", high);
  const auto from = builder().constantValue(low.number), to = builder().constantValue(high.number);
  if (from && to && *from > *to)
    tell("D1", cover(expr.parts[1].span, expr.parts[2].span), "this range is empty",
         "its end lies below its beginning", "write the smaller bound first", Severity::Warning);
  return algebra_.scalar(
      Type::Truth,
      builder().make(Op::And, {builder().make(Op::LessEqual, {low.number, x.number}),
                               builder().make(Op::LessEqual, {x.number, high.number})}));
}

Value ExpressionCompiler::evaluateIf(const Expr& expr) {
  const Value c = truth(expr.parts[0], "what follows `if`");
  const Value a = evaluate(expr.parts[1]), b = evaluate(expr.parts[2]);
  if (c.isAny() || a.isAny() || b.isAny()) return {};
  const bool isAlike =
      a.type == b.type && (a.type != Type::Geometric || std::abs(a.weight - b.weight) < 1e-9);
  if (!isAlike || a.type == Type::Shape) {
    tell("Y2", expr.span, "`then` and `else` must be of one type",
         describe(a) + " and " + describe(b),
         a.type == Type::Shape ? "use several `zone ... when ...` clauses for shapes"
                               : "let both give the same kind of value");
    return {};
  }
  const auto choose = [&](Node x, Node y) { return builder().make(Op::Select, {c.number, x, y}); };
  if (a.type == Type::Geometric)
    return algebra_.geometric({choose(a.at.x, b.at.x), choose(a.at.y, b.at.y)}, a.weight);
  return algebra_.scalar(a.type, choose(a.number, b.number));
}

Value ExpressionCompiler::evaluateBinary(const Expr& expr) {
  if (expr.name == "and" || expr.name == "or") return evaluateLogic(expr);
  if (expr.name == "|" || expr.name == "&") return shapeChain(expr);
  if (expr.name[0] == '<' || expr.name[0] == '>' || expr.name[0] == '=' || expr.name[0] == '!')
    return evaluateComparison(expr);
  const Value a = evaluate(expr.parts[0]), b = evaluate(expr.parts[1]);
  if (a.isAny() || b.isAny()) return {};
  if (expr.name == "+" || expr.name == "-") return add(expr, a, b);
  if (expr.name == "*") return multiply(expr, a, b);
  if (expr.name == "/") return divide(expr, a, b);
  return power(expr, a, b);
}

Value ExpressionCompiler::evaluate(const Expr& expr) {
  if (context_.stepsLeft == 0) return {};
  if (--context_.stepsLeft == 0) {
    tell("S6", expr.span, "the definitions of this file unfold to too many steps", "",
         "let definitions call others less often");
    return {};
  }
  switch (expr.kind) {
    case ExprKind::Missing:
      return {};
    case ExprKind::Number:
      return algebra_.number(expr.number);
    case ExprKind::Angle:
      return algebra_.angle(expr.number * std::numbers::pi / 180);
    case ExprKind::Name:
      return evaluateName(expr);
    case ExprKind::Imported:
      return evaluateImported(expr);
    case ExprKind::Call:
      return evaluateCall(expr);
    case ExprKind::Paren:
      return evaluate(expr.parts[0]);
    case ExprKind::Tuple:
      return evaluateTuple(expr);
    case ExprKind::Member:
      return evaluateMember(expr);
    case ExprKind::Negate:
    case ExprKind::Not:
      return evaluateUnary(expr);
    case ExprKind::Binary:
      return evaluateBinary(expr);
    case ExprKind::In:
      return evaluateRange(expr);
    case ExprKind::If:
      return evaluateIf(expr);
    case ExprKind::Fade:
      return fadeShapes(expr);
  }
  return {};
}

Value ExpressionCompiler::checkBody(const FunctionName& function) {
  const std::size_t count = function.parameters->size();
  for (std::size_t i = 0; i < count; ++i) {
    const Name& parameter = (*function.parameters)[i];
    Local local;
    local.span = parameter.span;
    local.kind = LocalKind::Parameter;
    // The last parameters of a metric are corners, whatever else it takes; others may be anything.
    constexpr std::size_t kFewestCorners = 3;
    if (function.isMetric && i + kFewestCorners >= count)
      local.value = algebra_.vertex(static_cast<int>(i + kFewestCorners - count));
    locals[parameter.text] = local;
  }
  return evaluate(*function.body);
}

}  // namespace af2::dsl
