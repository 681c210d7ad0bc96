// The value of an expression during compilation: its type, and the steps that compute it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dsl/program/program.h"
#include "dsl/shapes/shape.h"

namespace af2::dsl {

struct UserShape;

enum class Type {
  Any,  ///< unknown or faulty; accepted everywhere, and causes no further errors
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

/// A shape as a tree of constructors whose numbers are steps; in the same layout as Shape.
struct ShapeValue {
  ShapeKind kind = ShapeKind::Convex;
  std::vector<NodePair> points;
  std::vector<Node> numbers;
  std::vector<bool> arcs;
  std::vector<std::shared_ptr<const ShapeValue>> parts;
  std::shared_ptr<const UserShape> user;  ///< a registered shape; then only `numbers` is used,
  bool isReflected = false;  ///< `numbers` are in the frame reflected in the bisector of the base
};

struct Value {
  Type type = Type::Any;
  Node number = -1;   ///< for a Number, Truth, Angle
  NodePair at;        ///< for a Geometric
  double weight = 0;  ///< for a Geometric
  int vertex = -1;    ///< the vertex of the rule if the value is one, otherwise -1
  bool isNewVertex = false;
  std::shared_ptr<const ShapeValue> shape;

  bool isAny() const { return type == Type::Any; }
  bool isPoint() const;
  bool isVector() const;
};

/// "a number", "a point", "a sum of weight 2", ...
std::string describe(const Value& value);
/// The weight of a sum of points, as shown in messages.
std::string weightText(const Value& value);

/// The match that expressions of a rule can use, and the frame.
struct MatchFrame {
  int matchedVertices = 0;  ///< 0 if there is no match (constants, settings of a rule set)
  bool mirrored = false;    ///< x runs from b to a, and a and b are swapped
  /// The free angles from which a vertex wants 2, 3 and 4 elements, as `sweepOf` measures them; no
  /// value: the rule set has none.
  std::optional<std::array<double, 3>> counts = std::nullopt;
  int stored(int vertex) const { return mirrored && vertex < 2 ? 1 - vertex : vertex; }
};

/// The arithmetic of values: points, vectors, numbers.
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
  /// The matched vertex in this frame.
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
  /// Converts a point from this frame to the frame of the base edge; the identity unless mirrored.
  NodePair toBase(NodePair a) const;
  NodePair vectorToBase(NodePair a) const;

 private:
  ProgramBuilder& builder_;
  MatchFrame frame_;
};

}  // namespace af2::dsl
