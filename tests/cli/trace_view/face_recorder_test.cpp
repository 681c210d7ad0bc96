#include "cli/trace_view/face_recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "cli/trace_view/kept_fronts.h"
#include "dsl/load/rule_file.h"
#include "engine/optimize/optimize.h"
#include "engine/optimize/turn_round.h"
#include "tests/support/meshing.h"
#include "tests/support/random_domain.h"

namespace af2::cli {
namespace {

using namespace af2::testing;

struct Recorded {
  std::shared_ptr<const RuleSet> rules = triangleSet();
  FaceRecorder recorder;
  FrontInput input;
  MeshingResult result;

  /// As a region is meshed: inverted elements are turned round before the front is finished.
  void turnRound() { turnElementsRound(result.mesh, boundaryOf(input), FlatMaker(), {}); }

  explicit Recorded(StepRange charted) : Recorded(triangleSet(), charted, square(.1), .1) {}
  Recorded(std::shared_ptr<const RuleSet> set, StepRange charted, FrontInput in, double size)
      : rules(std::move(set)), recorder(*rules, 7, charted), input(std::move(in)) {
    FrontOptions options;
    options.observer = &recorder;
    result = AF2Algorithm(rules).execute(FlatMaker(), input, UniformSize(size), options);
  }

  void finish() {
    OptimizeOptions options;
    options.observer = &recorder;
    optimizeMesh(result.mesh, boundaryOf(input), FlatMaker(), options);
  }

  geometry::ModelMesh model() const {
    geometry::ModelMesh mesh;
    for (const SurfacePoint& vertex : result.mesh.vertices)
      mesh.vertices.push_back(vertex.position);
    mesh.elements = result.mesh.elements;
    mesh.face.assign(mesh.elements.size(), 7);
    return mesh;
  }
};

std::size_t aliveAtEnd(const FaceRecord& record) {
  return static_cast<std::size_t>(std::ranges::count(record.elements, kNever, &ViewElement::death));
}

TEST(FaceRecorder, HasTheElementsOfTheFrontAndThenThoseOfTheFinishedMesh) {
  Recorded run({1, 0});
  EXPECT_EQ(aliveAtEnd(run.recorder.record()), run.result.mesh.elements.size());
  EXPECT_EQ(run.recorder.record().events.size(), run.result.steps);
  run.finish();
  EXPECT_EQ(aliveAtEnd(run.recorder.record()), run.result.mesh.elements.size());
  EXPECT_GT(run.recorder.record().events.size(), run.result.steps);
  EXPECT_FALSE(run.recorder.record().missesChanges);
}

/// Welds, smoothing of rows, and changes after the front: whoever plays the record sees each vertex
/// where it was, and at the end has the mesh.
TEST(FaceRecorder, FollowsWeldsAndSmoothing) {
  const auto loaded = dsl::loadRules(AF2_SOURCE_DIR "/rules/quad/paving.af2");
  ASSERT_TRUE(loaded.rules);
  std::size_t welds = 0, rows = 0, turned = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    Recorded run(loaded.rules, {1, 0}, randomDomain(seed, 0.04), 0.04);
    if (hasTurnedElements(run.result.mesh)) {
      ++turned;
      run.turnRound();
    }
    run.finish();
    const FaceRecord& record = run.recorder.record();
    EXPECT_FALSE(record.missesChanges);
    EXPECT_EQ(aliveAtEnd(record), run.result.mesh.elements.size());
    welds += run.result.acts.welds;
    rows += static_cast<std::size_t>(
        std::ranges::count(record.events, ViewEvent::kRow, &ViewEvent::kind));
    std::vector<Point3> places = record.vertices;
    for (std::size_t i = 0; i < record.moves.size(); ++i) places[record.moved[i]] = record.moves[i];
    std::set<std::tuple<double, double, double>> shown, wanted;
    for (const ViewElement& element : record.elements)
      if (element.death == kNever)
        for (const std::uint32_t v : element.corners)
          if (v != ViewElement::kNoVertex) shown.emplace(places[v].x, places[v].y, 0);
    for (const SurfacePoint& v : run.result.mesh.vertices)
      wanted.emplace(v.position.x, v.position.y, 0);
    EXPECT_EQ(shown, wanted);
  }
  EXPECT_GT(welds, 0u);
  EXPECT_GT(rows, 10u);
  EXPECT_GT(turned, 0u);
}

TEST(FaceRecorder, MakesChartsOfTheWantedStepsOnly) {
  Recorded run({3, 5});
  const FaceRecord& record = run.recorder.record();
  ASSERT_EQ(record.charts.size(), 3u);
  EXPECT_EQ(record.events[1].chart, -1);
  EXPECT_EQ(record.events[2].chart, 0);
  EXPECT_EQ(record.events[4].chart, 2);
  EXPECT_EQ(record.events[5].chart, -1);
}

TEST(StepChart, HasTheBaseEdgeOnTheXAxisAndTheAppliedRuleFirst) {
  Recorded run({1, 1});
  const auto chart = nlohmann::json::parse(run.recorder.record().charts.at(0));
  const auto& from = chart["v"][chart["b"][0].get<std::size_t>()];
  const auto& to = chart["v"][chart["b"][1].get<std::size_t>()];
  EXPECT_EQ(from[1].get<double>(), 0);
  EXPECT_EQ(from[2].get<double>(), 0);
  EXPECT_NEAR(to[1].get<double>(), 1, 1e-3);
  EXPECT_EQ(to[2].get<double>(), 0);
  ASSERT_FALSE(chart["r"].empty());
  EXPECT_EQ(chart["r"][0][0].get<int>(), run.recorder.record().events[0].rule);
  EXPECT_EQ(chart["r"][0][1].get<int>(), static_cast<int>(Refusal::None));
}

TEST(KeptFronts, AreThoseWhoseInnerVerticesTheMeshHas) {
  Recorded run({1, 0});
  run.finish();
  FaceRecord& record = run.recorder.record();
  // Another attempt, of which the mesh has nothing.
  FrontInput input = square(.1);
  FrontOptions options;
  options.observer = &run.recorder;
  AF2Algorithm(triangleSet()).execute(FlatMaker(), input, UniformSize(.07), options);
  std::vector<FaceRecord*> faces{&record};
  markKeptFronts(run.model(), faces);
  ASSERT_EQ(record.fronts.size(), 2u);
  EXPECT_EQ(record.fronts[0].kept, ViewFront::Kept::Yes);
  EXPECT_EQ(record.fronts[1].kept, ViewFront::Kept::No);
}

}  // namespace
}  // namespace af2::cli
