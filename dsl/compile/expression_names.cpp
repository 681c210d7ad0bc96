// Resolves names in expressions, and suggests corrections for unknown names.
#include <algorithm>

#include "dsl/compile/expressions.h"
#include "dsl/program/builtins.h"
#include "dsl/program/compiled_forms.h"
#include "dsl/text/words.h"

namespace af2::dsl {

std::vector<std::string> ExpressionCompiler::namesInScope() const {
  std::vector<std::string> names;
  for (const auto& [name, local] : locals)
    if (local.kind != LocalKind::Broken) names.push_back(name);
  for (const auto& [name, constant] : module_->constants) names.push_back(name);
  if (hasLevel()) names.push_back("q");
  if (place_ == ExpressionPlace::Acceptance)
    names.insert(names.end(), {"score", "scaled_jacobian", "min_angle"});
  if (!corners.empty()) {  // a metric is meant
    for (const BuiltinMetric& metric : builtinMetrics()) names.emplace_back(metric.name);
    for (const auto& [name, function] : module_->functions)
      if (function.isMetric) names.push_back(name);
    for (const auto& [name, metric] : context_.registry.metrics()) names.push_back(name);
  }
  return names;
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

/// Definitions must stand above their uses, in the order of the text.
bool ExpressionCompiler::isBelow(const Expr& expr, const Module* home, Span definition) {
  return home == module_ && expr.qualifier.empty() && definition.begin > expr.span.begin;
}

Value ExpressionCompiler::usedTooEarly(const Expr& expr, Span definition) {
  const bool isItself =
      module_->source.lineOf(definition.begin) == module_->source.lineOf(expr.span.begin) &&
      definition.begin < expr.span.begin;
  tell(Code::UnknownName, expr.span,
       isItself ? "'" + expr.name + "' is defined in terms of itself"
                : "'" + expr.name + "' is used before it is defined",
       "", isItself ? "definitions cannot be recursive" : "move its definition up",
       {{"defined here", placeOf(module_->source, definition)}});
  return {};
}

Value ExpressionCompiler::unknownName(const Expr& expr, bool isFunction) {
  if (module_->brokenNames.contains(expr.name) || module_->hasBrokenImport) return {};
  if (!context_.mayGuess()) {
    tell(Code::UnknownName, expr.span, "there is no '" + expr.name + "' here");
    return {};
  }
  if (const auto below = definedBelow.find(expr.name);
      !isFunction && calls_.empty() && below != definedBelow.end())
    return usedTooEarly(expr, below->second);
  // After typing errors, the most common mistake is a definition below its use.
  for (const Item& item : module_->parsed.file.items) {
    using Found = const Name*;
    const Found name = match(
        item.content, [&](const Constant& c) { return isFunction ? Found() : &c.name; },
        [&](const AnyOf<Function, Metric, Extern> auto& f) {
          return isFunction ? &f.name : Found();
        },
        [](const AnyOf<std::monostate, Import, Use, RuleSetBlock, Rule, Template, Instance, Test,
                       Property> auto&) { return Found(); });
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
  if (help.empty() && !isFunction && place_ == ExpressionPlace::Constant && locals.empty())
    help = "constants are made of numbers and of constants above; vertices are known in rules";
  if (help.empty() && !isFunction) {
    std::string list;
    for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
    if (!list.empty() && list.size() < 120) help = "known here: " + list;
  }
  tell(Code::UnknownName, expr.span,
       std::string(isFunction ? "there is no function '" : "there is no '") + expr.name + "'" +
           (isFunction ? "" : " here"),
       "", help);
  if (!isFunction && place_ == ExpressionPlace::Rule && calls_.empty()) {
    Local broken;  // reported once for each rule
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
      tell(Code::UnknownName, expr.span, "there is no quality level here", "",
           "'" + expr.name + "' has a meaning in rules and rule sets only");
      return {};
    }
    return algebra_.scalar(Type::Number, builder().make(Op::Level, std::initializer_list<Node>{}));
  }
  if (place_ == ExpressionPlace::Acceptance) {
    using Acceptance = ExpressionAcceptance;
    const auto input = [&](Type type, int index) {
      return algebra_.scalar(type, builder().make(Op::Input, std::initializer_list<Node>{}, index));
    };
    if (expr.name == "score") return input(Type::Number, Acceptance::kScoreInput);
    if (expr.name == "scaled_jacobian")
      return input(Type::Number, Acceptance::kScaledJacobianInput);
    if (expr.name == "min_angle") return input(Type::Angle, Acceptance::kMinAngleInput);
  }
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
    tell(Code::UnknownName, expr.span,
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
  tell(Code::UnknownName, expr.span, "'" + expr.qualifier + "' has no constant '" + expr.name + "'",
       "", helpAmong(expr.name, known, "constants of that file"));
  return {};
}

}  // namespace af2::dsl
