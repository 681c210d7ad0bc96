#include "dsl/program/box_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "dsl/program/least_value.h"

namespace af2::dsl {
namespace {

/// Five coordinates, as a rule with two matched vertices beside the base has them.
constexpr int kVariables = 5;

std::vector<BoxVariable> variables(const Box& box) {
  return {{Op::CoordinateX, 1, box[0]},
          {Op::CoordinateX, 2, box[1]},
          {Op::CoordinateY, 2, box[2]},
          {Op::CoordinateX, 3, box[3]},
          {Op::CoordinateY, 3, box[4]}};
}

class RandomProgram {
 public:
  explicit RandomProgram(unsigned seed) : random_(seed) {
    for (const auto& [vertex, axis] : {std::pair{1, 'x'}, {2, 'x'}, {2, 'y'}, {3, 'x'}, {3, 'y'}})
      nodes_.push_back(builder_.coordinate(vertex, axis));
    for (const double c : {0.0, 1.0, 2.0, -0.7, 3.0}) nodes_.push_back(builder_.constant(c));
    for (int i = 0; i < 14; ++i) nodes_.push_back(step());
    program_ = builder_.program(nodes_);
  }

  const Program& program() const { return program_; }
  /// The program of one result alone.
  Program programOf(std::size_t result) const {
    return builder_.program(std::array<Node, 1>{nodes_[result]});
  }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

 private:
  Node any() { return nodes_[random_() % nodes_.size()]; }

  Node step() {
    // Every operation on values, those that are added later among them; but graphs hold no exact
    // turns, which have six arguments.
    Op op = Op::Unknown;
    while (!isArithmetic(op) || argumentCount(op) > 4)
      op = kOperations[random_() % kOperations.size()].op;
    std::array<Node, 4> arguments{any(), any(), any(), any()};
    const auto count = static_cast<std::size_t>(argumentCount(op));
    return builder_.make(op, std::span<const Node>(arguments).first(count));
  }

  std::mt19937 random_;
  ProgramBuilder builder_;
  std::vector<Node> nodes_;
  Program program_;
};

/// What a program gives at every point of a box lies within the bounds, and within those that its
/// slopes allow.
void expectBounds(RandomProgram& random, const Box& box) {
  const Program& program = random.program();
  BoxRun run(program, variables(box));
  run.run(box);
  std::vector<double> results(program.resultCount());
  for (int i = 0; i < 12; ++i) {
    std::array<double, kVariables> x;
    for (int v = 0; v < kVariables; ++v) x[v] = random.between(box[v].low, box[v].high);
    const std::array<Point2, 4> vertices{Point2{0, 0}, {x[0], 0}, {x[1], x[2]}, {x[3], x[4]}};
    program.run({vertices, 1, nullptr}, {}, results);
    for (std::size_t r = 0; r < results.size(); ++r) {
      if (std::isnan(results[r])) continue;
      const auto step = static_cast<std::size_t>(program.results()[r]);
      const Interval value = run.value(step);
      ASSERT_LE(value.low, results[r]) << static_cast<int>(program.steps()[step].op);
      ASSERT_GE(value.high, results[r]) << static_cast<int>(program.steps()[step].op);
      Interval centred = run.middle(step);
      for (std::size_t v = 0; v < kVariables; ++v)
        centred = centred + run.slope(step, v) * Interval::point(x[v] - box[v].middle());
      const double rounding = 1e-9 * (1 + std::abs(results[r]));
      ASSERT_LE(centred.low - rounding, results[r]) << static_cast<int>(program.steps()[step].op);
      ASSERT_GE(centred.high + rounding, results[r]) << static_cast<int>(program.steps()[step].op);
    }
  }
}

TEST(BoxRun, BoundsWhatProgramsGive) {
  for (unsigned seed = 1; seed <= 3000; ++seed) {
    RandomProgram random(seed);
    const double reach = std::pow(10, random.between(-4, 0.3));
    Box box;
    for (int v = 0; v < kVariables; ++v) {
      const double middle = random.between(-2, 2);
      box.push_back({middle - reach, middle + reach * random.between(0.1, 1)});
    }
    expectBounds(random, box);
    if (::testing::Test::HasFatalFailure()) FAIL() << "seed " << seed;
  }
}

TEST(LeastValue, IsNeverAboveWhatProgramsGive) {
  std::size_t bounded = 0;
  for (unsigned seed = 1; seed <= 3000; ++seed) {
    RandomProgram random(seed);
    std::vector<double> least, results(random.program().resultCount());
    for (std::size_t r = 0; r < results.size(); ++r)
      least.push_back(leastValue(random.programOf(r), 1));
    for (int i = 0; i < 12; ++i) {
      std::array<double, kVariables> x;
      for (double& each : x) each = random.between(-3, 3);
      const std::array<Point2, 4> vertices{Point2{0, 0}, {x[0], 0}, {x[1], x[2]}, {x[3], x[4]}};
      random.program().run({vertices, 1, nullptr}, {}, results);
      for (std::size_t r = 0; r < results.size(); ++r) {
        if (std::isnan(results[r])) continue;
        ASSERT_LE(least[r], results[r]) << "seed " << seed;
      }
    }
    bounded += static_cast<std::size_t>(
        std::ranges::count_if(least, [](double l) { return std::isfinite(l); }));
  }
  EXPECT_GT(bounded, 10000u);
}

TEST(BoxRun, IsTightForSmallBoxes) {
  ProgramBuilder builder;
  const Node x = builder.coordinate(2, 'x'), y = builder.coordinate(2, 'y');
  const Node size =
      builder.make(Op::SquareRoot, {builder.add(builder.multiply(x, x), builder.multiply(y, y))});
  const std::array<Node, 1> results{builder.divide(x, size)};
  const Program program = builder.program(results);
  const std::vector<BoxVariable> two{{Op::CoordinateX, 2, {}}, {Op::CoordinateY, 2, {}}};
  BoxRun run(program, two);
  run.run({{0.999, 1.001}, {0.999, 1.001}});
  const Interval value = run.value(static_cast<std::size_t>(program.results()[0]));
  EXPECT_NEAR(value.middle(), std::sqrt(0.5), 1e-6);
  EXPECT_LT(value.width(), 1.6e-3);
}

TEST(Interval, KnowsWhereCosinesTurn) {
  EXPECT_EQ(cosine({-0.1, 0.1}).high, 1);
  EXPECT_EQ(cosine({3.0, 3.3}).low, -1);
  EXPECT_LT(cosine({1, 1.1}).high, 0.5404);
}

TEST(Interval, DividesByWhatMayBeZeroIntoEverything) {
  EXPECT_EQ(Interval::point(1) / (Interval{-1, 1}), Interval::all());
}

}  // namespace
}  // namespace af2::dsl
