#include "dsl/compile/expressions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dsl/compile/allowed_codes.h"
#include "dsl/compile/type_help.h"
#include "dsl/text/diagnostic_codes.h"
#include "dsl/text/words.h"

namespace af2::dsl {

void ExpressionCompiler::warnIdle(Span span, std::string message, std::string help) {
  const auto isParameter = [](const auto& entry) {
    return entry.second.kind == LocalKind::Parameter;
  };
  if (algebra_.frame().mirrored || std::ranges::any_of(locals, isParameter)) return;
  tell(Code::IdleClause, span, std::move(message), "", std::move(help));
}

void ExpressionCompiler::tell(Code code, Span span, std::string message, std::string label,
                              Help help, std::vector<DiagnosticNote> notes,
                              std::optional<Severity> severity) {
  const Severity told = severity.value_or(infoOf(code).severity);
  if (!context_.diagnostics.takes(told)) return;
  Diagnostic d = finding(code, span, std::move(message), std::move(label), help, std::move(notes));
  d.severity = told;
  context_.diagnostics.add(std::move(d));
}

void ExpressionCompiler::tell(Diagnostic finding) { context_.diagnostics.add(std::move(finding)); }

Diagnostic ExpressionCompiler::finding(Code code, Span span, std::string message, std::string label,
                                       const Help& help, std::vector<DiagnosticNote> notes) const {
  Diagnostic d(code);
  d.message = std::move(message);
  d.label = std::move(label);
  setHelp(d, module_->source, span, help);
  d.notes = std::move(notes);
  d.rule = ruleTitle;
  if (calls_.empty()) {
    d.place = placeOf(module_->source, span);
  } else {
    // Inside a definition the fault is in the arguments, so it is reported at the call.
    d.place = placeOf(calls_.front().module->source, calls_.front().span);
    d.notes.push_back({"this is in the definition of '" + calls_.back().name + "'",
                       placeOf(module_->source, span)});
  }
  return d;
}

void ExpressionCompiler::checkAllowed(const MetaClause& meta) {
  for (const MetaEntry& entry : meta.entries)
    for (const std::string& code : codesListedIn(entry)) {
      if (findCode(code)) continue;
      std::vector<std::string> known;
      for (const CodeInfo& info : diagnosticCodes()) known.emplace_back(info.id);
      const Help guess = didYouMean(code, known);
      tell(Code::UnknownName, entry.value.span, "there is no code '" + code + "'", "",
           guess.empty() ? "messages show their codes; write for example `allow \"Z1, M1\";`"
                         : guess);
    }
}

Value ExpressionCompiler::wrongType(const Expr& expr, const Wanted& wanted, const Value& found,
                                    const std::string& use) {
  if (found.isAny()) return {};
  const std::string fault =
      use.empty() ? "this is not " + wanted.words : use + " must be " + wanted.words;
  const bool isWeight = found.type == Type::Geometric && !found.isPoint() && !found.isVector();
  if (isWeight) {
    tell(Code::PointWeights, expr.span, fault,
         "weights add up to " + weightText(found) + "; a point needs 1, a vector 0",
         "let the weights of the points add up to 1, as in `2*d - a`, or use mid, lerp, centroid");
    return {};
  }
  const bool wantsPoint = wanted.kind == Wanted::Kind::Point || wanted.kind == Wanted::Kind::Vector;
  tell(wantsPoint && found.type == Type::Geometric ? Code::PointWeights : Code::WrongType,
       expr.span, fault, "this is " + describe(found), wayToType(wanted.kind, found));
  return {};
}

Value ExpressionCompiler::needValue(const Expr& expr, Value value, const char* cause) {
  const auto isNothing = [&](Node node) {
    const auto constant = node >= 0 ? builder().constantValue(node) : std::nullopt;
    return constant && std::isnan(*constant);
  };
  const bool isBroken =
      value.type == Type::Geometric
          ? isNothing(value.at.x) || isNothing(value.at.y)
          : !value.isAny() && value.type != Type::Shape && isNothing(value.number);
  if (!isBroken) return value;
  tell(Code::NoValue, expr.span, "this never has a value", cause);
  return {};
}

Value ExpressionCompiler::number(const Expr& expr, const std::string& what) {
  const Value value = evaluate(expr);
  if (value.isAny() || value.type == Type::Number) return value;
  return wrongType(expr, wantedNumber(), value, what);
}

Value ExpressionCompiler::truth(const Expr& expr, const std::string& what) {
  const Value value = evaluate(expr);
  if (value.isAny() || value.type == Type::Truth) return value;
  wrongType(expr, wantedCondition(), value, what);
  return {};
}

Value ExpressionCompiler::point(const Expr& expr) {
  const Value value = evaluate(expr);
  if (value.isAny() || value.isPoint()) return value;
  return wrongType(expr, wantedPoint(), value);
}

std::optional<double> ExpressionCompiler::constantNumber(const Expr& expr,
                                                         const std::string& what) {
  if (expr.isMissing()) return std::nullopt;
  const Value value = number(expr, what);
  if (value.isAny()) return std::nullopt;
  const auto constant = builder().constantValue(value.number);
  if (!constant)
    tell(Code::NotConstant, expr.span, what + " must be a constant",
         "this depends on the match or on q", "use numbers, constants and parameters only");
  return constant;
}

Value ExpressionCompiler::evaluateTuple(const Expr& expr) {
  if (expr.parts.size() != 2) {
    tell(Code::WrongType, expr.span, "a vector has two coordinates",
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
    tell(Code::UnknownName, expr.span, "there is no part '" + expr.name + "'", "",
         "points and vectors have the parts x and y");
    return {};
  }
  if (whole.type != Type::Geometric)
    return wrongType(expr.parts[0], {Wanted::Kind::Point, "a point or vector"}, whole);
  if (!whole.isPoint() && !whole.isVector())
    return wrongType(expr.parts[0], {Wanted::Kind::Point, "a point or vector"}, whole);
  return algebra_.scalar(Type::Number, expr.name == "x" ? whole.at.x : whole.at.y);
}

Value ExpressionCompiler::evaluate(const Expr& expr) {
  if (context_.stepsLeft == 0) return {};
  if (--context_.stepsLeft == 0) {
    tell(Code::LimitExceeded, expr.span, "the definitions of this file unfold to too many steps",
         "", "reduce the number of calls in definitions");
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
    // The last parameters of a metric are corners; the other parameters may have any type.
    constexpr std::size_t kFewestCorners = 3;
    if (function.isMetric && i + kFewestCorners >= count)
      local.value = algebra_.vertex(static_cast<int>(i + kFewestCorners - count));
    locals[parameter.text] = local;
  }
  return evaluate(*function.body);
}

}  // namespace af2::dsl
