// Compiles operators in expressions for operands of each type.
#include <cmath>

#include "dsl/compile/expressions.h"
#include "dsl/compile/type_help.h"

namespace af2::dsl {
namespace {

constexpr const char* kTooLarge = "this is too large for a number; the largest is near 1e308";

}  // namespace

Value ExpressionCompiler::evaluateUnary(const Expr& expr) {
  if (expr.kind == ExprKind::Not) {
    const Value v = truth(expr.parts[0], "the operand of `not`");
    return v.isAny() ? v : algebra_.scalar(Type::Truth, builder().make(Op::Not, {v.number}));
  }
  const Value v = evaluate(expr.parts[0]);
  if (v.isAny()) return {};
  if (v.type == Type::Geometric)
    return algebra_.geometric({builder().negate(v.at.x), builder().negate(v.at.y)}, -v.weight);
  if (v.type == Type::Number || v.type == Type::Angle)
    return algebra_.scalar(v.type, builder().negate(v.number));
  return wrongType(expr.parts[0], {Wanted::Kind::Number, "a number, angle, point or vector"}, v);
}

Value ExpressionCompiler::wrongOperands(const Expr& expr, const Value& a, const Value& b,
                                        std::string help) {
  tell(Code::WrongOperands, expr.span,
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
    return needValue(
        expr,
        algebra_.geometric(isSum ? algebra_.add(a.at, b.at) : algebra_.subtract(a.at, b.at),
                           isSum ? a.weight + b.weight : a.weight - b.weight),
        kTooLarge);
  if (a.type == Type::Number || a.type == Type::Angle)
    return needValue(expr,
                     algebra_.scalar(a.type, builder().make(isSum ? Op::Add : Op::Subtract,
                                                            {a.number, b.number})),
                     kTooLarge);
  if (a.type == Type::Shape && !isSum) return shapeOf(ShapeKind::Difference, a, b);
  return wrongOperands(expr, a, b,
                       a.type == Type::Shape ? "shapes are joined by `|`, `&` and `-`"
                                             : "conditions are joined by `and`, `or`");
}

Value ExpressionCompiler::multiply(const Expr& expr, const Value& a, const Value& b) {
  if (b.type == Type::Geometric && a.type == Type::Number) {
    const auto constant = builder().constantValue(a.number);
    if (!b.isVector() && !constant) {
      tell(Code::PointWeights, expr.span, "the weight of a point must be a constant",
           "this weight depends on the match or on q",
           "use lerp(p, q, t) to move from p to q by a variable share");
      return {};
    }
    return needValue(
        expr,
        algebra_.geometric(algebra_.scale(a.number, b.at), b.isVector() ? 0 : *constant * b.weight),
        kTooLarge);
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
  return needValue(
      expr,
      algebra_.scalar(isAngle ? Type::Angle : Type::Number, builder().multiply(a.number, b.number)),
      kTooLarge);
}

Value ExpressionCompiler::divide(const Expr& expr, const Value& a, const Value& b) {
  if (a.type == Type::Geometric && b.type == Type::Number) {
    const auto constant = builder().constantValue(b.number);
    if (!a.isVector() && !constant) {
      tell(Code::PointWeights, expr.span, "the weight of a point must be a constant",
           "this weight depends on the match or on q",
           "use lerp(p, q, t) to move from p to q by a variable share");
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
  const std::string what = "an operand of `" + expr.name + "`";
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
  if (!isScalar) return wrongType(expr.parts[0], wantedBy('x'), x);
  const Wanted alike = x.type == Type::Angle ? wantedAngle() : wantedNumber();
  if (low.type != x.type) return wrongType(expr.parts[1], alike, low);
  if (high.type != x.type) return wrongType(expr.parts[2], alike, high);
  const auto from = builder().constantValue(low.number), to = builder().constantValue(high.number);
  if (from && to && *from > *to)
    tell(Code::IdleClause, cover(expr.parts[1].span, expr.parts[2].span), "this range is empty",
         "its end is less than its beginning", "write the smaller bound first");
  return algebra_.scalar(
      Type::Truth,
      builder().make(Op::And, {builder().make(Op::LessEqual, {low.number, x.number}),
                               builder().make(Op::LessEqual, {x.number, high.number})}));
}

Value ExpressionCompiler::evaluateIf(const Expr& expr) {
  const Value c = truth(expr.parts[0], "the argument of `if`");
  const Value a = evaluate(expr.parts[1]), b = evaluate(expr.parts[2]);
  if (c.isAny() || a.isAny() || b.isAny()) return {};
  const bool isAlike =
      a.type == b.type && (a.type != Type::Geometric || std::abs(a.weight - b.weight) < 1e-9);
  if (!isAlike || a.type == Type::Shape) {
    tell(Code::WrongOperands, expr.span, "`then` and `else` must be of one type",
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

}  // namespace af2::dsl
