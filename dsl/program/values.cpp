#include "dsl/program/values.h"

#include <cmath>
#include <cstdio>

namespace af2::dsl {
namespace {

constexpr double kWeightTolerance = 1e-9;  // weights are sums of decimal fractions

std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace

bool Value::isPoint() const {
  return type == Type::Geometric && std::abs(weight - 1) <= kWeightTolerance;
}

bool Value::isVector() const {
  return type == Type::Geometric && std::abs(weight) <= kWeightTolerance;
}

std::string describe(const Value& value) {
  switch (value.type) {
    case Type::Any:
      return "something unknown";
    case Type::Number:
      return "a number";
    case Type::Truth:
      return "a truth value";
    case Type::Angle:
      return "an angle";
    case Type::Shape:
      return "a shape";
    case Type::Geometric:
      break;
  }
  if (value.vertex >= 0) return "a vertex";
  if (value.isPoint()) return "a point";
  if (value.isVector()) return "a vector";
  return "a sum of points of weight " + weightText(value);
}

std::string weightText(const Value& value) { return shortNumber(value.weight); }

Value Algebra::scalar(Type type, Node node) const {
  Value v;
  v.type = type;
  v.number = node;
  return v;
}

Value Algebra::number(double value) const { return scalar(Type::Number, builder_.constant(value)); }
Value Algebra::angle(double radians) const {
  return scalar(Type::Angle, builder_.constant(radians));
}
Value Algebra::truth(bool value) const {
  return scalar(Type::Truth, builder_.constant(value ? 1 : 0));
}

Value Algebra::geometric(NodePair at, double weight) const {
  Value v;
  v.type = Type::Geometric;
  v.at = at;
  v.weight = weight;
  return v;
}

Value Algebra::vertex(int index) const {
  const int stored = frame_.stored(index);
  const NodePair inBase{builder_.coordinate(stored, 'x'), builder_.coordinate(stored, 'y')};
  Value v = point(toBase(inBase));  // reflecting twice is the identity
  v.vertex = index;
  return v;
}

NodePair Algebra::add(NodePair a, NodePair b) const {
  return {builder_.add(a.x, b.x), builder_.add(a.y, b.y)};
}

NodePair Algebra::subtract(NodePair a, NodePair b) const {
  return {builder_.subtract(a.x, b.x), builder_.subtract(a.y, b.y)};
}

NodePair Algebra::scale(Node s, NodePair a) const {
  return {builder_.multiply(s, a.x), builder_.multiply(s, a.y)};
}

Node Algebra::lerp(Node from, Node to, Node t) const {
  const Node rest = builder_.subtract(builder_.constant(1), t);
  return builder_.add(builder_.multiply(rest, from), builder_.multiply(t, to));
}

NodePair Algebra::lerp(NodePair from, NodePair to, Node t) const {
  return {lerp(from.x, to.x, t), lerp(from.y, to.y, t)};
}

Node Algebra::dot(NodePair a, NodePair b) const {
  return builder_.add(builder_.multiply(a.x, b.x), builder_.multiply(a.y, b.y));
}

Node Algebra::cross(NodePair a, NodePair b) const {
  return builder_.subtract(builder_.multiply(a.x, b.y), builder_.multiply(a.y, b.x));
}

Node Algebra::length(NodePair a) const { return builder_.make(Op::SquareRoot, {dot(a, a)}); }

NodePair Algebra::unit(NodePair a) const {
  const Node size = length(a);
  return {builder_.divide(a.x, size), builder_.divide(a.y, size)};
}

NodePair Algebra::perpendicular(NodePair a) const { return {builder_.negate(a.y), a.x}; }

NodePair Algebra::toBase(NodePair a) const {
  if (!frame_.mirrored) return a;
  const Node ends = builder_.add(builder_.coordinate(0, 'x'), builder_.coordinate(1, 'x'));
  return {builder_.subtract(ends, a.x), a.y};
}

NodePair Algebra::vectorToBase(NodePair a) const {
  return frame_.mirrored ? NodePair{builder_.negate(a.x), a.y} : a;
}

}  // namespace af2::dsl
