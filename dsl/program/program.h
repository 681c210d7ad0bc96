// Expressions of rules as flat programs: each step uses the results of earlier steps.
#pragma once

#include <array>
#include <boost/container/flat_map.hpp>
#include <boost/container/small_vector.hpp>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "dsl/program/operations.h"
#include "engine/rule/binding.h"
#include "engine/rule/point_transform.h"

namespace af2::dsl {

class ShapeProgram;
struct UserFunction;

/// An index of a step.
using Node = int;

struct Step {
  static constexpr int kMaxArguments = 9;  ///< a registered metric has four corners and the level
  Op op = Op::Unknown;
  double constant = 0;  ///< for a Constant
  int index = 0;        ///< the index of a vertex, an input, a shape or a registered function
  std::array<Node, kMaxArguments> arguments{-1, -1, -1, -1, -1, -1, -1, -1, -1};
  auto key() const { return std::tuple(op, constant, index, arguments); }
};

/// A program with any number of results. Immutable; pure; safe from several threads at once.
class Program {
 public:
  /// Runs on a match. Returns false if a result has no value. `inputs` are numbers from the caller.
  bool run(const AF2Binding& binding, std::span<const double> inputs,
           std::span<double> results) const;

  std::size_t resultCount() const { return results_.size(); }
  std::size_t stepCount() const { return steps_.size(); }
  std::span<const Step> steps() const { return steps_; }
  std::span<const Node> results() const { return results_; }

 private:
  friend class ProgramBuilder;
  std::vector<Step> steps_;
  std::vector<Node> results_;
  std::vector<std::shared_ptr<const ShapeProgram>> shapes_;
  std::vector<std::shared_ptr<const UserFunction>> functions_;
};

/// constant + sum of coefficient * coordinate, where coordinate 2 i is the x of vertex i, 2 i + 1
/// its y. Coefficients are never zero.
struct AffineForm {
  double constant = 0;
  /// Mostly one or two, so that they need no memory of their own.
  template <class Entry>
  using Few = boost::container::small_vector<Entry, 4>;
  boost::container::flat_map<int, double, std::less<>, Few<std::pair<int, double>>> coefficients;
};

/// Makes the steps of a program. It shares equal steps, folds constants, and tracks affine forms.
class ProgramBuilder {
 public:
  Node constant(double value);
  Node coordinate(int vertex, char axis);
  Node make(Op op, std::initializer_list<Node> arguments, int index = 0);
  Node make(Op op, std::span<const Node> arguments, int index = 0);

  Node add(Node a, Node b) { return make(Op::Add, {a, b}); }
  Node subtract(Node a, Node b) { return make(Op::Subtract, {a, b}); }
  Node multiply(Node a, Node b) { return make(Op::Multiply, {a, b}); }
  Node divide(Node a, Node b) { return make(Op::Divide, {a, b}); }
  Node negate(Node a) { return make(Op::Negate, {a}); }

  int addShape(std::shared_ptr<const ShapeProgram> shape);
  int addFunction(std::shared_ptr<const UserFunction> function);

  /// The number if it does not depend on a match; NaN if it is known to have no value.
  std::optional<double> constantValue(Node node) const;
  const std::optional<AffineForm>& affine(Node node) const { return affine_[index(node)]; }
  /// Whether the value depends on anything other than the quality level.
  bool dependsOnMatch(Node node) const;

  /// The steps that `results` need, in order.
  Program program(std::span<const Node> results) const;
  std::size_t size() const { return steps_.size(); }

 private:
  static std::size_t index(Node node) { return static_cast<std::size_t>(node); }
  Node insert(const Step& step);
  std::optional<AffineForm> affineOf(const Step& step) const;

  std::vector<Step> steps_;
  std::vector<std::optional<AffineForm>> affine_;
  std::vector<bool> dependsOnMatch_;
  std::map<decltype(Step().key()), Node> known_;
  std::vector<std::shared_ptr<const ShapeProgram>> shapes_;
  std::vector<std::shared_ptr<const UserFunction>> functions_;
};

}  // namespace af2::dsl
