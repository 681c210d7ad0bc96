// A graph of all expressions of a rule at one level, in which equal expressions share a node.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "dsl/match/match_sampler.h"
#include "dsl/program/box_run.h"
#include "dsl/program/program.h"
#include "dsl/program/values.h"
#include "dsl/proof/linear_forms.h"
#include "engine/rule/rule_set.h"

namespace af2::dsl {

/// A shape whose numbers are nodes; laid out as Shape lays out its own.
struct GraphShape {
  ShapeKind kind = ShapeKind::Convex;
  std::vector<NodePair> points;
  std::vector<Node> numbers;
  std::vector<bool> arcs;
  std::vector<GraphShape> parts;
};

/// One alternative of the free zone.
struct GraphZone {
  std::optional<GraphShape> shape;  ///< none: nothing is known about it
  std::vector<Node> truths,
      untruths;  ///< conditions that hold, and that fail, if it is used
};

/// Bounds of the matches of a graph that the pattern does not set; the same as for samples.
struct MatchDomain {
  Interval baseLengths{kShortestBase, kLongestBase};  ///< in multiples of the target size
  double farthestVertex = kFarthestVertex;
};

class RuleGraph {
 public:
  /// Throws Unknown if the graph cannot represent the position of a vertex of the rule.
  RuleGraph(const RuleSet& rules, const AF2Rule& rule, int level, const MatchDomain& domain = {});
  struct Unknown {};

  const std::vector<NodePair>& placed() const { return placed_; }  ///< matched, then new vertices
  const std::vector<GraphZone>& zones() const { return zones_; }   ///< alternatives, in order
  /// The coordinates of the match.
  const std::vector<BoxVariable>& variables() const { return variables_; }
  /// Nodes that are >= 0, and conditions that hold, at every match.
  const std::vector<Node>& facts() const { return facts_; }
  const std::vector<Node>& truths() const { return truths_; }

  // These functions make nodes. Equal nodes are made once; affine sums have one form, however they
  // are written.
  Node constant(double value) { return keep(builder_.constant(value)); }
  Node make(Op op, std::vector<Node> arguments, int index = 0);
  Node add(Node a, Node b) { return make(Op::Add, {a, b}); }
  Node subtract(Node a, Node b) { return make(Op::Subtract, {a, b}); }
  Node multiply(Node a, Node b) { return make(Op::Multiply, {a, b}); }
  Node negate(Node a) { return make(Op::Negate, {a}); }
  NodePair difference(NodePair p, NodePair q) { return {subtract(p.x, q.x), subtract(p.y, q.y)}; }
  NodePair between(NodePair p, NodePair q, double t);
  Node cross(NodePair u, NodePair v);
  Node dot(NodePair u, NodePair v);
  Node length(NodePair u) { return make(Op::SquareRoot, {dot(u, u)}); }
  /// Twice the signed area of p, q, r; 0 if two of them are the same.
  Node turn(NodePair p, NodePair q, NodePair r);

  /// The node of the condition; -1 if it contains a function that the graph cannot represent.
  Node importTruth(const AF2BindingFunction& function);
  /// The step that makes a node; meaningless for a constant.
  const Step& step(Node node) const { return steps_[static_cast<std::size_t>(node)]; }
  std::optional<double> constantValue(Node node) const { return builder_.constantValue(node); }
  LinearPoint linear(NodePair p) const { return {form(p.x), form(p.y)}; }
  /// Conclusions from a condition that holds, as nodes that are >= 0.
  void addConsequences(Node truth, std::vector<Node>& facts);
  void addOpposites(Node untruth, std::vector<Node>& facts);

  Program program(std::span<const Node> results) const { return builder_.program(results); }

 private:
  Node keep(Node node);
  Node importStep(const Step& step, const std::vector<Node>& imported);
  std::vector<Node> import(const Program& program);
  NodePair import(const AF2PointTransform& transform);
  void addVertices();
  void addTolerance(const ToleranceForm& form, NodePair deviation);
  void addNear(const NearPlace& near, NodePair at);
  Interval rangeOf(const PatternVertex& vertex, char axis) const;
  void addZones();
  GraphShape shapeOf(const ShapeValue& shape, const std::vector<Node>& numbers, std::size_t& next);
  NodePair toPrevious(int vertex, bool isPrevious);
  const LinearForm& form(Node node) const { return forms_[static_cast<std::size_t>(node)]; }
  LinearForm formOf(Op op, std::span<const Node> arguments, Node node) const;
  Node nodeOf(const LinearForm& form);

  const RuleSet& rules_;
  const RuleDefinition& rule_;
  int level_;
  MatchDomain domain_;
  ProgramBuilder builder_;
  std::vector<LinearForm> forms_;  // by node
  std::map<std::vector<std::pair<Node, double>>, Node> sums_;
  std::vector<Step> steps_;  // by node, for conditions
  std::vector<NodePair> placed_;
  std::vector<GraphZone> zones_;
  std::vector<BoxVariable> variables_;
  std::vector<Node> facts_, truths_;
  std::map<decltype(Step().key()), Node> unknowns_;  // by the step that makes the value
};

}  // namespace af2::dsl
