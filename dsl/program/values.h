// What an expression of a rule stands for while rules are compiled: its type, and the steps of the
// program that work it out.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dsl/program/program.h"
#include "dsl/shapes/shape.h"

namespace af2::dsl {

struct UserShape;

enum class Type {
  Any,  ///< not known, or broken: fits everywhere, and causes no errors
  Number,
  Truth,
  Angle,      ///< radians
  Geometric,  ///< a sum of points and vectors: a point if its weight is 1, a vector if it is 0
  Shape,
};

struct NodePair {
  Node x = -1, y = -1;
  bool operator==(const NodePair&) const = default;
};

/// A shape as a tree of constructors whose numbers are steps; laid out as Shape lays out its own.
struct ShapeValue {
  ShapeKind kind = ShapeKind::Convex;
  std::vector<NodePair> points;
  std::vector<Node> numbers;
  std::vector<bool> arcs;
  std::vector<std::shared_ptr<const ShapeValue>> parts;
  std::shared_ptr<const UserShape> user;  ///< a registered shape; then only `numbers` counts,
  bool isReflected = false;  ///< which are those of the frame reflected through the base's bisector
};

struct Value {
  Type type = Type::Any;
  Node number = -1;   ///< of a Number, Truth, Angle
  NodePair at;        ///< of a Geometric
  double weight = 0;  ///< of a Geometric
  int vertex = -1;    ///< the vertex of the rule that it is, if it is one
  bool isNewVertex = false;
  std::shared_ptr<const ShapeValue> shape;

  bool isAny() const { return type == Type::Any; }
  bool isPoint() const;
  bool isVector() const;
};

/// "a number", "a point", "a sum of weight 2", ...
std::string describe(const Value& value);
/// The weight of a sum of points, as messages show it.
std::string weightText(const Value& value);

/// What a rule's expressions may ask about the match, and in which frame.
struct MatchFrame {
  int matchedVertices = 0;  ///< 0: there is no match (constants, settings of a rule set)
  bool mirrored = false;    ///< x runs from b to a, and a and b have changed places
  int stored(int vertex) const { return mirrored && vertex < 2 ? 1 - vertex : vertex; }
};

/// Makes values out of values: the arithmetic of points, vectors, numbers.
class Algebra {
 public:
  Algebra(ProgramBuilder& builder, MatchFrame frame) : builder_(builder), frame_(frame) {}

  ProgramBuilder& builder() const { return builder_; }
  const MatchFrame& frame() const { return frame_; }

  Value number(double value) const;
  Value angle(double radians) const;
  Value truth(bool value) const;
  Value scalar(Type type, Node node) const;
  Value geometric(NodePair at, double weight) const;
  Value point(NodePair at) const { return geometric(at, 1); }
  Value vector(NodePair at) const { return geometric(at, 0); }
  /// The matched vertex, seen from the frame.
  Value vertex(int index) const;

  NodePair add(NodePair a, NodePair b) const;
  NodePair subtract(NodePair a, NodePair b) const;
  NodePair scale(Node s, NodePair a) const;
  NodePair lerp(NodePair from, NodePair to, Node t) const;
  Node lerp(Node from, Node to, Node t) const;
  Node dot(NodePair a, NodePair b) const;
  Node cross(NodePair a, NodePair b) const;
  Node length(NodePair a) const;
  NodePair unit(NodePair a) const;
  NodePair perpendicular(NodePair a) const;
  /// The point of the base's frame that the frame's point is; the identity unless mirrored.
  NodePair toBase(NodePair a) const;
  NodePair vectorToBase(NodePair a) const;

 private:
  ProgramBuilder& builder_;
  MatchFrame frame_;
};

}  // namespace af2::dsl
