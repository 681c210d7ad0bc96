// Shapes in expressions, and corners that fade.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dsl/compile/expressions.h"
#include "dsl/compile/type_help.h"
#include "dsl/program/builtins.h"
#include "dsl/program/shape_program.h"

namespace af2::dsl {
namespace {

Value shapeValue(ShapeValue shape) {
  Value v;
  v.type = Type::Shape;
  v.shape = std::make_shared<const ShapeValue>(std::move(shape));
  return v;
}

const Expr& withoutParens(const Expr& expr) {
  const Expr* e = &expr;
  while (e->kind == ExprKind::Paren) e = &e->parts[0];
  return *e;
}

/// Operands and operators of a chain of | & -, which have one precedence.
void flatten(const Expr& expr, std::vector<const Expr*>& operands,
             std::vector<const Expr*>& operators) {
  const bool isChain =
      expr.kind == ExprKind::Binary && (expr.name == "|" || expr.name == "&" || expr.name == "-");
  if (!isChain) {
    operands.push_back(&expr);
    return;
  }
  flatten(expr.parts[0], operands, operators);
  operators.push_back(&expr);
  flatten(expr.parts[1], operands, operators);
}

bool isSameTree(const ShapeValue& a, const ShapeValue& b) {
  if (a.kind != b.kind || a.points.size() != b.points.size() ||
      a.numbers.size() != b.numbers.size() || a.arcs != b.arcs ||
      a.parts.size() != b.parts.size() || a.user != b.user)
    return false;
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    if (!isSameTree(*a.parts[i], *b.parts[i])) return false;
  return true;
}

ShapeValue blended(const Algebra& algebra, const ShapeValue& preferred, const ShapeValue& limiting,
                   Node t) {
  ShapeValue result = preferred;
  for (std::size_t i = 0; i < result.points.size(); ++i)
    result.points[i] = algebra.lerp(limiting.points[i], preferred.points[i], t);
  for (std::size_t i = 0; i < result.numbers.size(); ++i)
    result.numbers[i] = algebra.lerp(limiting.numbers[i], preferred.numbers[i], t);
  for (std::size_t i = 0; i < result.parts.size(); ++i)
    result.parts[i] = std::make_shared<const ShapeValue>(
        blended(algebra, *preferred.parts[i], *limiting.parts[i], t));
  return result;
}

/// Whether two trees have the same structure; equal numbers share one step.
bool isSameShape(const ShapeValue& a, const ShapeValue& b) {
  const auto isSame = [](const auto& p, const auto& q) { return isSameShape(*p, *q); };
  return a.points == b.points && a.numbers == b.numbers &&
         std::ranges::equal(a.parts, b.parts, isSame);
}

bool hasUserPart(const ShapeValue& shape) {
  return shape.user ||
         std::ranges::any_of(shape.parts, [](const auto& part) { return hasUserPart(*part); });
}

}  // namespace

ExpressionCompiler::Corner ExpressionCompiler::corner(const Expr& given) {
  const Expr& expr = withoutParens(given);
  if (expr.kind != ExprKind::Fade) return {point(given), std::nullopt};
  Corner result;
  result.preferred = point(expr.parts[0]);
  result.limiting = point(expr.parts[1]);
  if (!result.preferred.isAny() && result.preferred.at == result.limiting->at) tellNoFade(expr);
  return result;
}

void ExpressionCompiler::tellNoFade(const Expr& expr) {
  warnIdle(expr.span, "this does not fade: both sides of '=>' are the same",
           "write one of them, or another limit");
}

NodePair ExpressionCompiler::fadedPoint(const Expr& expr) {
  const Corner c = corner(expr);
  if (c.preferred.isAny() || (c.limiting && c.limiting->isAny())) return {};
  if (!c.limiting) return c.preferred.at;
  return algebra_.lerp(c.limiting->at, c.preferred.at, fade ? fade() : builder().constant(1));
}

Value ExpressionCompiler::fadeShapes(const Expr& expr) {
  if (!fade) {
    tell(Code::UnmatchedShapes, expr.span, "'=>' has no meaning here", "",
         "corners and shapes fade in `zone` clauses only");
    return {};
  }
  const Value preferred = evaluate(expr.parts[0]), limiting = evaluate(expr.parts[1]);
  if (preferred.isAny() || limiting.isAny()) return {};
  for (int i = 0; i < 2; ++i) {
    const Value& side = i == 0 ? preferred : limiting;
    if (side.type != Type::Number && side.type != Type::Angle) continue;
    tell(Code::WrongType, expr.parts[i].span, "only points and shapes fade",
         "this is " + describe(side),
         "fade the whole shape, as in `disc(c, 2) => disc(c, 1)`, or let the number depend on the "
         "level, "
         "as in `1 + 1/q`");
    return {};
  }
  if (preferred.isPoint() && limiting.isPoint() && preferred.at == limiting.at) tellNoFade(expr);
  if (preferred.isPoint() && limiting.isPoint())
    return algebra_.point(algebra_.lerp(limiting.at, preferred.at, fade()));
  if (preferred.type != Type::Shape) return wrongType(expr.parts[0], wantedShape(), preferred);
  if (limiting.type != Type::Shape) return wrongType(expr.parts[1], wantedShape(), limiting);
  if (!isSameTree(*preferred.shape, *limiting.shape)) {
    tell(Code::UnmatchedShapes, expr.span, "these two shapes cannot fade into each other",
         std::string("'") + toString(preferred.shape->kind) + "' and '" +
             toString(limiting.shape->kind) + "' have different structures",
         "both sides need the same constructors with the same number of corners");
    return {};
  }
  if (isSameShape(*preferred.shape, *limiting.shape)) tellNoFade(expr);
  return shapeValue(blended(algebra_, *preferred.shape, *limiting.shape, fade()));
}

Value ExpressionCompiler::shape(const Expr& expr) {
  const Value value = evaluate(expr);
  if (value.isAny() || value.type == Type::Shape) return value;
  return wrongType(expr, wantedShape(), value);
}

Value ExpressionCompiler::shapeOf(ShapeKind kind, const Value& first, const Value& second) {
  ShapeValue result;
  result.kind = kind;
  result.parts = {first.shape, second.shape};
  return shapeValue(std::move(result));
}

Value ExpressionCompiler::shapeChain(const Expr& expr) {
  std::vector<const Expr*> operands, operators;
  flatten(expr, operands, operators);
  Value result = shape(*operands[0]);
  for (std::size_t i = 0; i < operators.size(); ++i) {
    const Value next = shape(*operands[i + 1]);
    if (result.isAny() || next.isAny()) {
      result = {};
      continue;
    }
    const std::string& op = operators[i]->name;
    result = shapeOf(op == "|"   ? ShapeKind::Union
                     : op == "&" ? ShapeKind::Intersection
                                 : ShapeKind::Difference,
                     result, next);
  }
  return result;
}

Value ExpressionCompiler::polyShape(const Expr& expr) {
  ShapeValue result;
  result.kind = ShapeKind::Poly;
  bool isRight = true;
  for (const Expr& given : expr.parts) {
    const Expr& step = withoutParens(given);
    const bool isArc = step.kind == ExprKind::Call && step.name == "arc" &&
                       step.qualifier.empty() && !module_->functions.contains("arc");
    if (isArc && step.parts.size() != 2) {
      tell(Code::ArgumentCount, step.span,
           "'arc' is called with " + std::to_string(step.parts.size()) + " arguments", "",
           "the call is arc(via, to): from the corner before, through `via`, to `to`");
      isRight = false;
      continue;
    }
    result.arcs.push_back(isArc);
    const std::span<const Expr> parts =
        isArc ? std::span<const Expr>(step.parts) : std::span<const Expr>(&given, 1);
    for (const Expr& part : parts) {
      result.points.push_back(fadedPoint(part));
      isRight = isRight && result.points.back().x >= 0;
    }
  }
  if (isRight && result.points.size() < 3) {
    tell(Code::ArgumentCount, expr.span, "a path needs three corners or an arc", "",
         "the call is poly(p, q, r, ...)");
    isRight = false;
  }
  return isRight ? shapeValue(std::move(result)) : Value{};
}

/// A registered shape only answers queries; its boundary is not known.
bool ExpressionCompiler::isGrownUser(const Expr& expr, const ShapeValue& shape) {
  if (!hasUserPart(shape)) return false;
  tell(Code::UnmatchedShapes, expr.span, "a registered shape cannot be grown", "",
       "give the shape itself a distance as one more argument");
  return true;
}

Value ExpressionCompiler::callShape(const Expr& expr) {
  const std::string usage(usageOf(expr.name));
  if (expr.name == "poly") return polyShape(expr);
  if (expr.name == "arc") {
    tell(Code::UnmatchedShapes, expr.span, "an arc is allowed only in the path of a poly", "",
         "write poly(p, arc(via, to), ...)");
    return {};
  }
  const std::string kinds = expr.name == "disc"     ? "pn"
                            : expr.name == "left"   ? "pv"
                            : expr.name == "sector" ? "pnaa"
                            : expr.name == "grow"
                                ? "sn"
                                : std::string(std::max<std::size_t>(1, expr.parts.size()), 'p');
  if (expr.parts.size() != kinds.size()) {
    tellOfCount(expr, usage);
    return {};
  }
  ShapeValue result;
  result.kind = expr.name == "disc"     ? ShapeKind::Disc
                : expr.name == "left"   ? ShapeKind::Left
                : expr.name == "sector" ? ShapeKind::Sector
                : expr.name == "grow"   ? ShapeKind::Grow
                                        : ShapeKind::Hull;
  bool isRight = true;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] == 's') {
      const Value part = shape(expr.parts[i]);
      if (part.isAny() || isGrownUser(expr.parts[i], *part.shape))
        isRight = false;
      else
        result.parts.push_back(part.shape);
      continue;
    }
    if (kinds[i] == 'p') {
      result.points.push_back(fadedPoint(expr.parts[i]));
      isRight = isRight && result.points.back().x >= 0;
      continue;
    }
    const Value v = evaluate(expr.parts[i]);
    if (!fits(v, kinds[i], nullptr, expr.parts[i], usage))
      isRight = false;
    else if (kinds[i] == 'v')
      result.points.push_back(v.at);
    else
      result.numbers.push_back(v.number);
  }
  if (isRight && (expr.name == "disc" || expr.name == "grow" || expr.name == "sector")) {
    const auto size = builder().constantValue(result.numbers[0]);
    if (size && *size < 0) {
      tell(Code::UnboundedZone, expr.parts[1].span, "a negative radius or distance", "",
           "use a number of at least 0");
      isRight = false;
    }
  }
  return isRight ? shapeValue(std::move(result)) : Value{};
}

Value ExpressionCompiler::callUserShape(const Expr& expr,
                                        const std::shared_ptr<const UserShape>& user) {
  ShapeValue result;
  result.kind = ShapeKind::User;
  result.user = user;
  if (expr.parts.size() != user->parameters.size()) {
    tell(Code::ArgumentCount, expr.span,
         "'" + expr.name + "' is called with " + std::to_string(expr.parts.size()) + " arguments",
         "", "it takes " + std::to_string(user->parameters.size()));
    return {};
  }
  for (std::size_t i = 0; i < expr.parts.size(); ++i) {
    const Value v = evaluate(expr.parts[i]);
    if (!fits(v, user->parameters[i], nullptr, expr.parts[i], expr.name)) return {};
    if (v.type == Type::Geometric)
      result.numbers.insert(result.numbers.end(), {v.at.x, v.at.y});
    else
      result.numbers.push_back(v.number);
  }
  return shapeValue(std::move(result));
}

Value ExpressionCompiler::inside(const Expr& expr) {
  if (expr.parts.size() != 2) {
    tell(Code::ArgumentCount, expr.span,
         "'inside' is called with " + std::to_string(expr.parts.size()) + " arguments", "",
         "the call is inside(p, shape)");
    return {};
  }
  const Value p = point(expr.parts[0]);
  const Value s = shape(expr.parts[1]);
  if (p.isAny() || s.isAny()) return {};
  const NodePair at = algebra_.toBase(p.at);
  const int index = builder().addShape(
      std::make_shared<const ShapeProgram>(builder(), reflected(algebra_, *s.shape)));
  return algebra_.scalar(Type::Truth, builder().make(Op::Inside, {at.x, at.y}, index));
}

ShapeValue reflected(const Algebra& algebra, const ShapeValue& shape) {
  if (!algebra.frame().mirrored) return shape;
  ProgramBuilder& b = algebra.builder();
  ShapeValue result = shape;
  result.isReflected = true;
  for (auto& part : result.parts)
    part = std::make_shared<const ShapeValue>(reflected(algebra, *part));
  for (std::size_t i = 0; i < result.points.size(); ++i)
    result.points[i] = algebra.toBase(shape.points[i]);
  if (shape.kind == ShapeKind::Convex) {
    std::reverse(result.points.begin(), result.points.end());
  } else if (shape.kind == ShapeKind::Left) {
    result.points[1] = {shape.points[1].x, b.negate(shape.points[1].y)};  // left stays left
  } else if (shape.kind == ShapeKind::Sector) {
    const Node half = b.constant(std::numbers::pi);
    result.numbers[1] = b.subtract(half, shape.numbers[2]);
    result.numbers[2] = b.subtract(half, shape.numbers[1]);
  } else if (shape.kind == ShapeKind::Poly) {
    // In reverse order, every step leads back to its start; an arc keeps its intermediate point.
    std::vector<NodePair> ends, vias;
    std::size_t next = 0;
    for (bool isArc : shape.arcs) {
      vias.push_back(isArc ? result.points[next++] : NodePair{});
      ends.push_back(result.points[next++]);
    }
    const std::size_t n = ends.size();
    std::vector<NodePair> points;
    std::vector<bool> arcs;
    for (std::size_t i = n; i-- > 0;) {
      arcs.push_back(shape.arcs[i]);
      if (shape.arcs[i]) points.push_back(vias[i]);
      points.push_back(ends[(i + n - 1) % n]);
    }
    result.points = std::move(points);
    result.arcs = std::move(arcs);
  }
  return result;
}

}  // namespace af2::dsl
