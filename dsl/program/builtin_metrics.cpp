// The predefined measures of elements, as steps of programs. Source: docs/references.md.
#include <array>
#include <cmath>
#include <numbers>

#include "dsl/program/builtins.h"

namespace af2::dsl {
namespace {

using Values = std::span<const Value>;

std::vector<NodePair> edgesOf(const Algebra& a, Values corners) {
  std::vector<NodePair> edges;
  for (std::size_t i = 0; i < corners.size(); ++i)
    edges.push_back(a.subtract(corners[(i + 1) % corners.size()].at, corners[i].at));
  return edges;
}

Node sum(const Algebra& a, std::span<const Node> terms) {
  Node result = terms[0];
  for (Node term : terms.subspan(1)) result = a.builder().add(result, term);
  return result;
}

std::vector<Node> lengths(const Algebra& a, Values corners) {
  std::vector<Node> result;
  for (NodePair edge : edgesOf(a, corners)) result.push_back(a.length(edge));
  return result;
}

Node area(const Algebra& a, Values corners) {
  std::vector<Node> terms;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    terms.push_back(a.cross(a.subtract(corners[i].at, corners[0].at),
                            a.subtract(corners[i + 1].at, corners[0].at)));
  return a.builder().multiply(a.builder().constant(0.5), sum(a, terms));
}

/// `value` where `positive` > 0, otherwise no value.
Node whereOf(const Algebra& a, Node positive, Node value) {
  ProgramBuilder& b = a.builder();
  const Node isPositive = b.make(Op::Less, {b.constant(0), positive});
  return b.make(Op::Select, {isPositive, value, b.constant(std::nan(""))});
}

/// Sum over the edges of l + 1/l - 2.
Node sizeTerm(const Algebra& a, std::span<const Node> edgeLengths) {
  ProgramBuilder& b = a.builder();
  std::vector<Node> terms;
  for (Node l : edgeLengths)
    terms.push_back(b.subtract(b.add(l, b.divide(b.constant(1), l)), b.constant(2)));
  return sum(a, terms);
}

/// Perimeter^2 / area divided by its smallest possible value, minus 1.
Node shapeTerm(const Algebra& a, Values corners) {
  ProgramBuilder& b = a.builder();
  const double best = corners.size() == 3 ? 12 * std::sqrt(3.0) : 16;
  const Node perimeter = sum(a, lengths(a, corners));
  const Node size = area(a, corners);
  const Node ratio = b.divide(b.multiply(perimeter, perimeter), b.multiply(size, b.constant(best)));
  return whereOf(a, size, b.subtract(ratio, b.constant(1)));
}

Value shapeSize(const Algebra& a, Values weights, Values corners) {
  ProgramBuilder& b = a.builder();
  const Node shape = b.multiply(weights[0].number, shapeTerm(a, corners));
  return a.scalar(Type::Number, b.add(shape, sizeTerm(a, lengths(a, corners))));
}

Value sizeError(const Algebra& a, Values, Values corners) {
  return a.scalar(Type::Number, sizeTerm(a, lengths(a, corners)));
}

Value aspectBadness(const Algebra& a, Values, Values corners) {
  return a.scalar(Type::Number, shapeTerm(a, corners));
}

/// |J|^2 / (4 det J) - 1/2 of the map with the columns u, v: 0 for rotations and scalings.
Node jacobianTerm(const Algebra& a, NodePair u, NodePair v) {
  ProgramBuilder& b = a.builder();
  const Node det = a.cross(u, v);
  const Node square = b.add(a.dot(u, u), a.dot(v, v));
  const Node ratio = b.divide(square, b.multiply(b.constant(4), det));
  return whereOf(a, det, b.subtract(ratio, b.constant(0.5)));
}

/// Mean over the 2 x 2 Gauss points of the bilinear map; a triangle is compared with the
/// equilateral one.
Value jacobianBadness(const Algebra& a, Values, Values corners) {
  ProgramBuilder& b = a.builder();
  const auto edges = edgesOf(a, corners);
  if (corners.size() == 3) {
    const NodePair u = edges[0], toApex = a.subtract(corners[2].at, corners[0].at);
    const NodePair half = a.scale(b.constant(0.5), u);
    const NodePair v = a.scale(b.constant(2 / std::sqrt(3.0)), a.subtract(toApex, half));
    return a.scalar(Type::Number, jacobianTerm(a, u, v));
  }
  const NodePair bottom = edges[0], top = a.scale(b.constant(-1), edges[2]);
  const NodePair right = edges[1], left = a.scale(b.constant(-1), edges[3]);
  std::vector<Node> terms;
  for (double s : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)})
    for (double t : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)})
      terms.push_back(
          jacobianTerm(a, a.lerp(bottom, top, b.constant(t)), a.lerp(left, right, b.constant(s))));
  return a.scalar(Type::Number, b.multiply(b.constant(0.25), sum(a, terms)));
}

/// The smallest signed sine of the angles at the corners; for triangles it is scaled so that the
/// equilateral one has 1. It is limited to 1, so that bounds of scores are known.
Value scaledJacobian(const Algebra& a, Values, Values corners) {
  ProgramBuilder& b = a.builder();
  const auto edges = edgesOf(a, corners);
  const std::size_t n = edges.size();
  Node least = -1;
  for (std::size_t i = 0; i < n; ++i) {
    const NodePair before = edges[(i + n - 1) % n], after = edges[i];
    const Node sine =
        b.divide(a.cross(before, after), b.multiply(a.length(before), a.length(after)));
    least = least < 0 ? sine : b.make(Op::Minimum, {least, sine});
  }
  if (n == 3) least = b.multiply(b.constant(2 / std::sqrt(3.0)), least);
  least = b.make(Op::Minimum, {least, b.constant(1)});
  return a.scalar(Type::Number, least);
}

/// The smallest interior angle.
Value minAngle(const Algebra& a, Values, Values corners) {
  ProgramBuilder& b = a.builder();
  const std::size_t n = corners.size();
  Node least = -1;
  for (std::size_t i = 0; i < n; ++i) {
    const NodePair from = a.subtract(corners[(i + 1) % n].at, corners[i].at);
    const NodePair to = a.subtract(corners[(i + n - 1) % n].at, corners[i].at);
    const Node angle = b.make(Op::Sweep, {from.x, from.y, to.x, to.y});
    least = least < 0 ? angle : b.make(Op::Minimum, {least, angle});
  }
  return a.scalar(Type::Angle, least);
}

constexpr std::array kMetrics{
    BuiltinMetric{"shape_size", 1, "shape_size(weight)", shapeSize,
                  "Metric: shape and edge lengths of an element."},
    BuiltinMetric{"jacobian_badness", 0, "jacobian_badness", jacobianBadness,
                  "Metric: 0 for the equilateral triangle and the square."},
    BuiltinMetric{"size_error", 0, "size_error", sizeError,
                  "Metric: 0 if all edges have the target size."},
    BuiltinMetric{"aspect_badness", 0, "aspect_badness", aspectBadness,
                  "Metric: 0 for the equilateral triangle and the square."},
    BuiltinMetric{"scaled_jacobian", 0, "scaled_jacobian(u, v, w, x)", scaledJacobian,
                  "Measure: 1 for the ideal element, 0 for a flat one."},
    BuiltinMetric{"min_angle", 0, "min_angle(u, v, w, x)", minAngle,
                  "Measure: the smallest corner."},
};

}  // namespace

std::span<const BuiltinMetric> builtinMetrics() { return kMetrics; }

const BuiltinMetric* findBuiltinMetric(std::string_view name) {
  for (const BuiltinMetric& m : kMetrics)
    if (m.name == name) return &m;
  return nullptr;
}

}  // namespace af2::dsl
