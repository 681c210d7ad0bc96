#include "cli/trace_view/face_recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/trace_view/kept_fronts.h"
#include "engine/optimize/optimize.h"
#include "tests/support/meshing.h"

namespace af2::cli {
namespace {

using namespace af2::testing;

struct Recorded {
  std::shared_ptr<const RuleSet> rules = triangleSet();
  FaceRecorder recorder;
  FrontInput input = square(.1);
  MeshingResult result;

  explicit Recorded(StepRange charted) : recorder(*rules, 7, charted) {
    FrontOptions options;
    options.observer = &recorder;
    result = AF2Algorithm(rules).execute(FlatMaker(), input, UniformSize(.1), options);
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
