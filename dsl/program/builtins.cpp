#include "dsl/program/builtins.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace af2::dsl {
namespace {

using Arguments = std::span<const Value>;

Value keepType(const Algebra& a, const Value& like, Node node) { return a.scalar(like.type, node); }

template <Op op>
Value numberFunction(const Algebra& a, Arguments v) {
  return a.scalar(Type::Number, a.builder().make(op, {v[0].number}));
}

Value squareRoot(const Algebra& a, Arguments v) { return numberFunction<Op::SquareRoot>(a, v); }
Value sine(const Algebra& a, Arguments v) { return numberFunction<Op::Sine>(a, v); }
Value cosine(const Algebra& a, Arguments v) { return numberFunction<Op::Cosine>(a, v); }
Value tangent(const Algebra& a, Arguments v) { return numberFunction<Op::Tangent>(a, v); }
Value atan2(const Algebra& a, Arguments v) {
  return a.scalar(Type::Angle, a.builder().make(Op::Atan2, {v[0].number, v[1].number}));
}
Value absolute(const Algebra& a, Arguments v) {
  return keepType(a, v[0], a.builder().make(Op::Absolute, {v[0].number}));
}

template <Op op>
Value extreme(const Algebra& a, Arguments v) {
  Node result = v[0].number;
  for (const Value& other : v.subspan(1)) result = a.builder().make(op, {result, other.number});
  return keepType(a, v[0], result);
}

Value clamp(const Algebra& a, Arguments v) {
  const Node low = a.builder().make(Op::Maximum, {v[0].number, v[1].number});
  return keepType(a, v[0], a.builder().make(Op::Minimum, {low, v[2].number}));
}

Value mid(const Algebra& a, Arguments v) {
  return a.geometric(a.lerp(v[0].at, v[1].at, a.builder().constant(0.5)), v[0].weight);
}

Value lerp(const Algebra& a, Arguments v) {
  if (v[0].type != Type::Geometric)
    return keepType(a, v[0], a.lerp(v[0].number, v[1].number, v[2].number));
  return a.geometric(a.lerp(v[0].at, v[1].at, v[2].number), v[0].weight);
}

Value centroid(const Algebra& a, Arguments v) {
  NodePair sum = v[0].at;
  for (const Value& p : v.subspan(1)) sum = a.add(sum, p.at);
  const Node count = a.builder().constant(static_cast<double>(v.size()));
  return a.point({a.builder().divide(sum.x, count), a.builder().divide(sum.y, count)});
}

Value perp(const Algebra& a, Arguments v) { return a.vector(a.perpendicular(v[0].at)); }

Value rot(const Algebra& a, Arguments v) {
  const Node c = a.builder().make(Op::Cosine, {v[1].number});
  const Node s = a.builder().make(Op::Sine, {v[1].number});
  const NodePair along = a.scale(c, v[0].at), across = a.scale(s, a.perpendicular(v[0].at));
  return a.vector(a.add(along, across));
}

Value unit(const Algebra& a, Arguments v) { return a.vector(a.unit(v[0].at)); }
Value len(const Algebra& a, Arguments v) { return a.scalar(Type::Number, a.length(v[0].at)); }
Value dot(const Algebra& a, Arguments v) { return a.scalar(Type::Number, a.dot(v[0].at, v[1].at)); }
Value cross(const Algebra& a, Arguments v) {
  return a.scalar(Type::Number, a.cross(v[0].at, v[1].at));
}
Value dist(const Algebra& a, Arguments v) {
  return a.scalar(Type::Number, a.length(a.subtract(v[1].at, v[0].at)));
}

NodePair footOf(const Algebra& a, NodePair p, NodePair q, NodePair r) {
  const NodePair along = a.subtract(r, q);
  const Node t = a.builder().divide(a.dot(a.subtract(p, q), along), a.dot(along, along));
  return a.add(q, a.scale(t, along));
}

Value foot(const Algebra& a, Arguments v) { return a.point(footOf(a, v[0].at, v[1].at, v[2].at)); }

Value reflect(const Algebra& a, Arguments v) {
  const NodePair base = footOf(a, v[0].at, v[1].at, v[2].at);
  return a.point(a.subtract(a.scale(a.builder().constant(2), base), v[0].at));
}

Value cut(const Algebra& a, Arguments v) {
  const Node t =
      a.builder().divide(a.cross(a.subtract(v[2].at, v[0].at), v[3].at), a.cross(v[1].at, v[3].at));
  return a.point(a.add(v[0].at, a.scale(t, v[1].at)));
}

/// The angle at v runs counter-clockwise from v->q to v->p.
template <Op op>
Node atCorner(const Algebra& a, Arguments v) {
  const NodePair from = a.subtract(v[2].at, v[1].at), to = a.subtract(v[0].at, v[1].at);
  return a.builder().make(op, {from.x, from.y, to.x, to.y});
}

Value bisector(const Algebra& a, Arguments v) {
  return a.vector({atCorner<Op::BisectX>(a, v), atCorner<Op::BisectY>(a, v)});
}
Value angle(const Algebra& a, Arguments v) {
  return a.scalar(Type::Angle, atCorner<Op::Sweep>(a, v));
}

template <Op op, Type type>
Value ofVertex(const Algebra& a, Arguments v) {
  return a.scalar(
      type, a.builder().make(op, std::initializer_list<Node>{}, a.frame().stored(v[0].vertex)));
}

template <Op op>
Value ofPlace(const Algebra& a, Arguments v) {
  const NodePair p = a.toBase(v[0].at);
  return a.scalar(Type::Number, a.builder().make(op, {p.x, p.y}));
}

template <Op opX, Op opY>
NodePair neighbour(const Algebra& a, const Value& v) {
  const int vertex = a.frame().stored(v.vertex);
  const std::initializer_list<Node> none{};
  return a.toBase({a.builder().make(opX, none, vertex), a.builder().make(opY, none, vertex)});
}

/// A mirrored front runs the other way.
Value before(const Algebra& a, Arguments v) {
  return a.point(a.frame().mirrored ? neighbour<Op::AfterX, Op::AfterY>(a, v[0])
                                    : neighbour<Op::BeforeX, Op::BeforeY>(a, v[0]));
}
Value after(const Algebra& a, Arguments v) {
  return a.point(a.frame().mirrored ? neighbour<Op::BeforeX, Op::BeforeY>(a, v[0])
                                    : neighbour<Op::AfterX, Op::AfterY>(a, v[0]));
}

Value count(const Algebra& a, Arguments v) {
  ProgramBuilder& b = a.builder();
  const auto bounds = a.frame().counts.value_or(std::array{0.0, 0.0, 0.0});
  return a.scalar(
      Type::Number,
      b.make(Op::Count, {b.constant(bounds[0]), b.constant(bounds[1]), b.constant(bounds[2])},
             a.frame().stored(v[0].vertex)));
}

/// From an end of the base edge along the edge between its first two elements: the free angle is
/// divided into as many parts as the vertex wants elements, but into none below 60 or above 120
/// degrees, and the spoke is so long that it ends at the target size above the base edge.
Value spoke(const Algebra& a, Arguments v) {
  ProgramBuilder& b = a.builder();
  const bool isB = v[0].vertex == 1;
  const Node turn = ofVertex<Op::TurnOrStraight, Type::Angle>(a, v).number;
  const Node share = b.divide(turn, b.make(Op::Maximum, {count(a, v).number, b.constant(1)}));
  const double third = std::numbers::pi / 3;
  const Node part =
      b.make(Op::Minimum, {b.make(Op::Maximum, {share, b.constant(third)}), b.constant(2 * third)});
  const NodePair along = a.unit(a.subtract(a.vertex(isB ? 0 : 1).at, a.vertex(isB ? 1 : 0).at));
  const std::array turned{a.vector(along), a.scalar(Type::Angle, isB ? b.negate(part) : part)};
  const Node length =
      b.divide(ofVertex<Op::SizeOf, Type::Number>(a, v).number, b.make(Op::Sine, {part}));
  return a.vector(a.scale(length, rot(a, turned).at));
}

/// The n-th of the values; the last one beyond them.
Value pick(const Algebra& a, Arguments v) {
  ProgramBuilder& b = a.builder();
  Node result = v.back().number;
  for (std::size_t i = v.size() - 1; i-- > 1;) {
    const Node reaches = b.make(Op::LessEqual, {v[0].number, b.constant(static_cast<double>(i))});
    result = b.make(Op::Select, {reaches, v[i].number, result});
  }
  return a.scalar(v[1].type, result);
}

Value loopSize(const Algebra& a, Arguments) {
  return a.scalar(Type::Number, a.builder().make(Op::LoopSize, std::initializer_list<Node>{}));
}

/// The number of elements that a vertex of the front needs: 1 end, 2 side, 3 corner, 4 reversal.
Value corner(const Algebra& a, Arguments v) {
  ProgramBuilder& b = a.builder();
  const Node turn = ofVertex<Op::Turn, Type::Angle>(a, v).number;
  Node result = b.constant(1);
  for (double degrees : {130.0, 235.0, 315.0}) {
    const Node bound = b.constant(degrees * std::numbers::pi / 180);
    result = b.add(result, b.make(Op::LessEqual, {bound, turn}));
  }
  return a.scalar(Type::Number, result);
}

Node turns(const Algebra& a, Op op, const Value& p, const Value& q, const Value& r) {
  return a.builder().make(op, {p.at.x, p.at.y, q.at.x, q.at.y, r.at.x, r.at.y});
}

Value ccw(const Algebra& a, Arguments v) {
  return a.scalar(Type::Truth, turns(a, Op::LeftTurn, v[0], v[1], v[2]));
}

/// No corner turns right, and no corner is clockwise of the first edge as seen from its start, so
/// the corners make exactly one turn.
Value convex(const Algebra& a, Arguments v) {
  ProgramBuilder& b = a.builder();
  const std::size_t n = v.size();
  Node result = turns(a, Op::NotRightTurn, v[0], v[1], v[2 % n]);
  for (std::size_t i = 1; i < n; ++i)
    result =
        b.make(Op::And, {result, turns(a, Op::NotRightTurn, v[i], v[(i + 1) % n], v[(i + 2) % n])});
  for (std::size_t i = 2; i + 1 < n; ++i)
    result = b.make(Op::And, {result, turns(a, Op::NotRightTurn, v[0], v[i], v[i + 1])});
  return a.scalar(Type::Truth, result);
}

constexpr std::array kBuiltins{
    Builtin{"sqrt", "n", "sqrt(x)", squareRoot, "The square root."},
    Builtin{"sin", "r", "sin(angle)", sine, "The sine; a plain number is in radians."},
    Builtin{"cos", "r", "cos(angle)", cosine, "The cosine; a plain number is in radians."},
    Builtin{"tan", "r", "tan(angle)", tangent, "The tangent; a plain number is in radians."},
    Builtin{"atan2", "nn", "atan2(y, x)", atan2, "The angle of the vector (x, y)."},
    Builtin{"abs", "x", "abs(x)", absolute, "The value without its sign."},
    Builtin{"min", "xx*", "min(x, y, ...)", extreme<Op::Minimum>, "The smallest."},
    Builtin{"max", "xx*", "max(x, y, ...)", extreme<Op::Maximum>, "The largest."},
    Builtin{"clamp", "xxx", "clamp(x, low, high)", clamp, "x, but not below low nor above high."},
    Builtin{"pick", "nn*", "pick(n, x, y, ...)", pick,
            "The n-th of the values; the last one if there are fewer."},
    Builtin{"mid", "gg", "mid(p, q)", mid, "The point halfway."},
    Builtin{"lerp", "lln", "lerp(from, to, t)", lerp,
            "from at t = 0, to at t = 1; t may lie outside."},
    Builtin{"centroid", "p*", "centroid(p, q, ...)", centroid, "The mean of points."},
    Builtin{"perp", "v", "perp(v)", perp, "The vector, turned by 90 degrees counter-clockwise."},
    Builtin{"rot", "va", "rot(v, angle)", rot, "The vector, turned counter-clockwise."},
    Builtin{"unit", "v", "unit(v)", unit, "The vector at length 1."},
    Builtin{"len", "v", "len(v)", len, "The length of a vector."},
    Builtin{"dot", "vv", "dot(u, v)", dot, "The scalar product."},
    Builtin{"cross", "vv", "cross(u, v)", cross, "The z component of the vector product."},
    Builtin{"dist", "pp", "dist(p, q)", dist, "The distance of two points."},
    Builtin{"foot", "ppp", "foot(p, q, r)", foot, "The foot of p on the line through q and r."},
    Builtin{"cut", "pvpv", "cut(p, u, q, v)", cut,
            "The intersection of the line through p along u with that through q along v."},
    Builtin{"bisector", "ppp", "bisector(p, v, q)", bisector,
            "The unit vector that halves angle(p, v, q)."},
    Builtin{"reflect", "ppp", "reflect(p, q, r)", reflect,
            "p, reflected in the line through q and r."},
    Builtin{"angle", "ppp", "angle(p, v, q)", angle,
            "Counter-clockwise from v->q to v->p, above 0 and up to 360deg."},
    Builtin{"turn", "c", "turn(v)", ofVertex<Op::Turn, Type::Angle>,
            "The free angle at a vertex of a chain."},
    Builtin{"corner", "c", "corner(v)", corner,
            "1 end, 2 side, 3 corner, 4 reversal, by the free angle."},
    Builtin{"count", "c", "count(v)", count,
            "How many elements v wants in its free angle, by the `counts` of the rule set."},
    Builtin{"spoke", "e", "spoke(v)", spoke,
            "From a or b along the edge beside the base edge that divides the free angle evenly."},
    Builtin{"before", "c", "before(v)", before, "The vertex before v on the front."},
    Builtin{"after", "c", "after(v)", after, "The vertex after v on the front."},
    Builtin{"h", "p", "h(p)", ofPlace<Op::SizeAt>,
            "The target size at p, relative to that at the base edge."},
    Builtin{"layer", "w", "layer(v)", ofVertex<Op::Layer, Type::Number>,
            "Layers of elements between v and the boundary."},
    Builtin{"on_boundary", "w", "on_boundary(v)", ofVertex<Op::OnBoundary, Type::Truth>,
            "Whether v lies on the boundary."},
    Builtin{"valence", "w", "valence(v)", ofVertex<Op::Valence, Type::Number>,
            "The number of elements at v so far."},
    Builtin{"fixed", "w", "fixed(v)", ofVertex<Op::IsFixed, Type::Truth>,
            "Whether v was given with the boundary."},
    Builtin{"loop_size", "", "loop_size()", loopSize,
            "The number of edges of this loop of the front."},
    Builtin{"dist_front", "p", "dist_front(p)", ofPlace<Op::FrontDistance>,
            "The distance to the nearest front edge."},
    Builtin{"curvature", "p", "curvature(p)", ofPlace<Op::CurvatureAt>,
            "The curvature of the surface times the target size."},
    Builtin{"ccw", "ppp", "ccw(p, q, r)", ccw, "Whether three points turn left; exact."},
    Builtin{"convex", "ppp*", "convex(p, q, r, ...)", convex,
            "Whether corners form a convex polygon; exact."},
};

struct ShapeFunction {
  std::string_view name, usage, help;
};

constexpr std::array kShapes{
    ShapeFunction{"poly", "poly(p, q, r, ...)",
                  "A simple polygon, counter-clockwise; arc(via, to) may be a corner."},
    ShapeFunction{"hull", "hull(p, q, ...)", "The convex hull."},
    ShapeFunction{"disc", "disc(centre, radius)", "A disc."},
    ShapeFunction{"left", "left(point, direction)",
                  "The half plane to the left of the line through p along v."},
    ShapeFunction{"sector", "sector(centre, radius, from, to)",
                  "Counter-clockwise between two angles from the x axis."},
    ShapeFunction{"grow", "grow(shape, distance)", "All points within a distance of the shape."},
    ShapeFunction{"arc", "arc(via, to)", "In a poly: along a circle through via."},
    ShapeFunction{"inside", "inside(p, shape)", "Whether the closed shape holds the point."},
};

}  // namespace

std::span<const Builtin> builtins() { return kBuiltins; }

const Builtin* findBuiltin(std::string_view name) {
  for (const Builtin& b : kBuiltins)
    if (b.name == name) return &b;
  return nullptr;
}

bool isShapeFunction(std::string_view name) {
  return std::ranges::find(kShapes, name, &ShapeFunction::name) != kShapes.end();
}

std::string_view usageOf(std::string_view name) {
  if (const Builtin* builtin = findBuiltin(name)) return builtin->usage;
  if (const BuiltinMetric* metric = findBuiltinMetric(name)) return metric->usage;
  const auto shape = std::ranges::find(kShapes, name, &ShapeFunction::name);
  return shape == kShapes.end() ? name : shape->usage;
}

std::string_view helpOf(std::string_view name) {
  if (const Builtin* builtin = findBuiltin(name)) return builtin->help;
  if (const BuiltinMetric* metric = findBuiltinMetric(name)) return metric->help;
  const auto shape = std::ranges::find(kShapes, name, &ShapeFunction::name);
  return shape == kShapes.end() ? std::string_view() : shape->help;
}

bool isBuiltin(std::string_view name) {
  return findBuiltin(name) || findBuiltinMetric(name) || isShapeFunction(name);
}

std::vector<std::string> builtinNames() {
  std::vector<std::string> names;
  for (const Builtin& b : kBuiltins) names.emplace_back(b.name);
  for (const BuiltinMetric& m : builtinMetrics()) names.emplace_back(m.name);
  for (const ShapeFunction& s : kShapes) names.emplace_back(s.name);
  return names;
}

}  // namespace af2::dsl
