#include "engine/step/front_piece.h"

#include <gtest/gtest.h>

#include "engine/run/algorithm.h"
#include "engine/step/single_step.h"
#include "tests/support/flat_surface.h"
#include "tests/support/fronts.h"
#include "tests/support/meshing.h"
#include "tests/support/triangle_rules.h"

namespace af2 {
namespace {

using namespace af2::testing;

/// Keeps the front around every step.
class Watcher final : public AF2MeshingObserver {
 public:
  bool wantsFrontAround(const StepReport&) const override { return true; }
  void frontBegun(const FrontInput&) override { ++fronts; }
  void frontAround(const StepReport& step, const LocalFront& around) override {
    steps.push_back(step);
    pieces.push_back(around);
  }
  void frontEnded(std::size_t left) override { edgesLeft = left; }

  int fronts = 0;
  std::size_t edgesLeft = 1;
  std::vector<StepReport> steps;
  std::vector<LocalFront> pieces;
};

TEST(LocalFront, HasTheBaseEdgeOnTheXAxisAndTheIdsOfItsVertices) {
  Watcher watcher;
  FrontOptions options;
  options.observer = &watcher;
  const AF2Algorithm algorithm(triangleSet());
  const MeshingResult result =
      algorithm.execute(FlatMaker(), discWithHole(.1), UniformSize(.1), options);
  ASSERT_EQ(result.outcome, Outcome::Complete);
  EXPECT_EQ(watcher.fronts, 1);
  EXPECT_EQ(watcher.edgesLeft, 0u);
  ASSERT_EQ(watcher.pieces.size(), result.steps);
  for (std::size_t i = 0; i < watcher.pieces.size(); ++i) {
    const auto& [piece, ids] = watcher.pieces[i];
    ASSERT_EQ(ids.size(), piece.vertices.size());
    EXPECT_EQ(ids[piece.base.first], watcher.steps[i].from);
    EXPECT_EQ(ids[piece.base.second], watcher.steps[i].to);
    EXPECT_NEAR(length(piece.vertices[piece.base.first]), 0, 1e-12);
    EXPECT_NEAR(piece.vertices[piece.base.second].y, 0, 1e-12);
    EXPECT_EQ(piece.level, watcher.steps[i].level);
    EXPECT_DOUBLE_EQ(piece.size, 1);
  }
}

TEST(LocalFront, IsAllThatAStepDependsOnInThePlane) {
  Watcher watcher;
  FrontOptions options;
  options.observer = &watcher;
  const auto set = triangleSet();
  AF2Algorithm(set).execute(FlatMaker(), discWithHole(.1), UniformSize(.1), options);
  SingleStepper stepper(*set);
  std::size_t same = 0;
  for (std::size_t i = 0; i < watcher.pieces.size(); ++i) {
    const auto chosen = stepper.chosenRule(watcher.pieces[i].piece);
    same += watcher.steps[i].applied ? chosen == watcher.steps[i].rule : !chosen;
  }
  EXPECT_EQ(same, watcher.pieces.size());
}

TEST(LocalFront, IsKeptForEdgesThatAreStuck) {
  RuleSetDefinition definition = triangleSetDefinition();
  definition.maxLevel = 1;
  definition.matchTolerance.resize(1);
  definition.acceptance = std::make_shared<ScoreBound>(std::vector<double>{-1});
  const MeshingResult result = AF2Algorithm(std::make_shared<RuleSet>(std::move(definition)))
                                   .execute(FlatMaker(), discWithHole(.2), UniformSize(.2));
  ASSERT_EQ(result.outcome, Outcome::Stuck);
  ASSERT_GT(result.stuck.size(), 10u);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_GE(result.stuck[i].around.piece.vertices.size(), 4u);
    for (const RuleRefusal& refusal : result.stuck[i].refusals)
      EXPECT_EQ(refusal.matched.empty(), refusal.matches == 0);
  }
}

}  // namespace
}  // namespace af2
