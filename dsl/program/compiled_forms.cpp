#include "dsl/program/compiled_forms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace af2::dsl {
namespace {

/// One front edge as a match with only the vertices a and b.
class EdgeSurroundings final : public AF2Surroundings {
 public:
  explicit EdgeSurroundings(const FrontEdgeFacts& edge) : edge_(edge) {}
  std::optional<double> turn(int vertex) const override {
    return vertex == 0 ? edge_.turnA : edge_.turnB;
  }
  int layer(int vertex) const override { return vertex == 0 ? edge_.layerA : edge_.layerB; }
  int count(int vertex, const std::array<double, 3>& bounds) const override {
    const int own = vertex == 0 ? edge_.ownCountA : edge_.ownCountB;
    return own > 0 ? own : countOf(vertex == 0 ? edge_.sweepA : edge_.sweepB, bounds);
  }

 private:
  const FrontEdgeFacts& edge_;
};

AffinePointTransform affineTransform(const AffineForm& x, const AffineForm& y) {
  std::map<int, AffinePointTransform::Term> terms;
  const auto termOf = [&](int coordinate) -> AffinePointTransform::Term& {
    AffinePointTransform::Term& term = terms[coordinate / 2];
    term.vertex = coordinate / 2;
    return term;
  };
  for (const auto& [coordinate, c] : x.coefficients) {
    if (coordinate % 2 == 0)
      termOf(coordinate).xx = c;
    else
      termOf(coordinate).xy = c;
  }
  for (const auto& [coordinate, c] : y.coefficients) {
    if (coordinate % 2 == 0)
      termOf(coordinate).yx = c;
    else
      termOf(coordinate).yy = c;
  }
  std::vector<AffinePointTransform::Term> list;
  for (const auto& [vertex, term] : terms) list.push_back(term);
  return AffinePointTransform({x.constant, y.constant}, std::move(list));
}

}  // namespace

std::optional<Point2> ExpressionTransform::transformPoint(const AF2Binding& binding) const {
  std::array<double, 2> at;
  if (!program_.run(binding, {}, at)) return std::nullopt;
  return Point2{at[0], at[1]};
}

std::optional<double> ExpressionFunction::evaluate(const AF2Binding& binding) const {
  std::array<double, 1> result;
  if (!program_.run(binding, {}, result)) return std::nullopt;
  return result[0];
}

std::optional<double> ExpressionMetric::badnessAt(std::span<const Point2> corners,
                                                  int level) const {
  const auto& program = corners.size() == 3 ? triangle_ : quad_;
  std::array<double, 1> result;
  if (!program || !program->run({corners, level, nullptr}, {}, result)) return std::nullopt;
  return result[0];
}

double ExpressionMetric::leastAt(int corners, int level) const {
  const auto& program = corners == 3 ? triangle_ : quad_;
  return program ? leastValue(*program, level) : 0;
}

ExpressionAcceptance::ExpressionAcceptance(Program program) : program_(std::move(program)) {
  for (const Step& step : program_.steps())
    needsMeasures_ = needsMeasures_ || (step.op == Op::Input && step.index != kScoreInput);
}

bool ExpressionAcceptance::acceptsMeasured(double score, int level,
                                           const ElementMeasures& measures) const {
  std::array<double, 1> result;
  const std::array<double, 3> inputs{score, measures.scaledJacobian, measures.minAngle};
  return program_.run({{}, level, nullptr}, inputs, result) && result[0] != 0;
}

ExpressionFrontOrder::ExpressionFrontOrder(std::vector<Program> keys) : keys_(std::move(keys)) {
  for (const Program& key : keys_)
    for (const Step& step : key.steps()) {
      needsTurns_ = needsTurns_ || step.op == Op::Turn || step.op == Op::TurnOrStraight;
      needsSweeps_ = needsSweeps_ || step.op == Op::Count;
    }
}

double ExpressionFrontOrder::key(int index, const FrontEdgeFacts& edge) const {
  const std::array<Point2, 2> ends{Point2{0, 0}, Point2{edge.length, 0}};
  const EdgeSurroundings surroundings(edge);
  std::array<double, 1> result;
  // A key without a value sorts last, regardless of the other keys.
  if (!keys_[static_cast<std::size_t>(index)].run({ends, edge.level, &surroundings}, {}, result))
    return std::numeric_limits<double>::max();
  return result[0];
}

std::shared_ptr<const AF2PointTransform> makeTransform(const ProgramBuilder& builder, NodePair at) {
  const auto& x = builder.affine(at.x);
  const auto& y = builder.affine(at.y);
  if (x && y) return std::make_shared<AffinePointTransform>(affineTransform(*x, *y));
  const std::array<Node, 2> results{at.x, at.y};
  return std::make_shared<ExpressionTransform>(builder.program(results));
}

std::shared_ptr<const AF2BindingFunction> makeFunction(const ProgramBuilder& builder, Node node) {
  const std::array<Node, 1> results{node};
  return std::make_shared<ExpressionFunction>(builder.program(results));
}

}  // namespace af2::dsl
