// Expressions in the general forms of the engine, evaluated by programs.
#pragma once

#include <memory>
#include <vector>

#include "dsl/program/least_value.h"
#include "dsl/program/program.h"
#include "dsl/program/values.h"
#include "engine/rule/element_metric.h"
#include "engine/rule/front_order.h"
#include "engine/rule/point_transform.h"

namespace af2::dsl {

/// A placement that is not an affine map.
class ExpressionTransform final : public AF2PointTransform {
 public:
  explicit ExpressionTransform(Program program) : program_(std::move(program)) {}
  std::optional<Point2> transformPoint(const AF2Binding& binding) const override;
  const Program& program() const { return program_; }

 private:
  Program program_;
};

/// A condition or a cost.
class ExpressionFunction final : public AF2BindingFunction {
 public:
  explicit ExpressionFunction(Program program) : program_(std::move(program)) {}
  std::optional<double> evaluate(const AF2Binding& binding) const override;
  double leastAt(int level) const override { return leastValue(program_, level); }
  const Program& program() const { return program_; }

 private:
  Program program_;
};

/// A metric written in a rule file: one program for triangles and one for quadrilaterals. In both,
/// the corners are the matched vertices.
class ExpressionMetric final : public AF2ElementMetric {
 public:
  ExpressionMetric(std::optional<Program> triangle, std::optional<Program> quad)
      : triangle_(std::move(triangle)), quad_(std::move(quad)) {}
  /// At level 1.
  std::optional<double> badness(std::span<const Point2> corners) const override {
    return badnessAt(corners, 1);
  }
  std::optional<double> badnessAt(std::span<const Point2> corners, int level) const override;
  double leastAt(int corners, int level) const override;

 private:
  std::optional<Program> triangle_, quad_;
};

/// `accept` in its general form. The inputs of the program are the score and measures of the new
/// elements.
class ExpressionAcceptance final : public AF2Acceptance {
 public:
  static constexpr int kScoreInput = 0, kScaledJacobianInput = 1, kMinAngleInput = 2;

  explicit ExpressionAcceptance(Program program);
  /// For ideal quadrilaterals.
  bool accepts(double score, int level) const override { return acceptsMeasured(score, level, {}); }
  bool needsMeasures() const override { return needsMeasures_; }
  bool acceptsMeasured(double score, int level, const ElementMeasures& measures) const override;

 private:
  Program program_;
  bool needsMeasures_ = false;
};

/// `front by` in its general form.
class ExpressionFrontOrder final : public AF2FrontOrder {
 public:
  explicit ExpressionFrontOrder(std::vector<Program> keys);
  int keyCount() const override { return static_cast<int>(keys_.size()); }
  double key(int index, const FrontEdgeFacts& edge) const override;
  bool needsTurns() const override { return needsTurns_; }
  bool needsSweeps() const override { return needsSweeps_; }

 private:
  std::vector<Program> keys_;
  bool needsTurns_ = false, needsSweeps_ = false;
};

/// The affine form if there is one, otherwise the general form.
std::shared_ptr<const AF2PointTransform> makeTransform(const ProgramBuilder& builder, NodePair at);

std::shared_ptr<const AF2BindingFunction> makeFunction(const ProgramBuilder& builder, Node node);

}  // namespace af2::dsl
