// How a run is followed, stopped and ended; what goes wrong and how it is told.
#include "engine/run/algorithm.h"

#include <gtest/gtest.h>

#include <atomic>
#include <ctime>
#include <limits>
#include <stdexcept>
#include <thread>

#include "engine/base/error.h"
#include "tests/support/meshing.h"
#include "tests/support/recorded_run.h"

namespace af2 {
namespace {

using namespace af2::testing;

std::shared_ptr<const RuleSet> setOf(std::vector<AF2Rule> rules) {
  RuleSetDefinition set = triangleSetDefinition();
  set.rules = std::move(rules);
  return std::make_shared<RuleSet>(set);
}

// ---- observers and progress --------------------------------------------------------------------

TEST(Observer, HearsOfEachStep) {
  Recorder recorder(false);
  FrontOptions options;
  options.observer = &recorder;
  const FrontInput input = discWithHole(.05);
  const MeshingResult result = run(input, .05, options);
  ASSERT_EQ(result.outcome, Outcome::Complete);
  ASSERT_EQ(recorder.steps.size(), result.steps);
  EXPECT_TRUE(recorder.refusals.empty());
  std::size_t failed = 0, elements = 0;
  for (const StepReport& step : recorder.steps) {
    failed += !step.applied;
    EXPECT_EQ(step.applied, step.elements > elements);
    elements = step.elements;
    EXPECT_GE(step.level, 1);
    EXPECT_TRUE(!step.applied || step.rule == result.mesh.origins[elements - 1].rule);
  }
  EXPECT_EQ(failed, result.failedSteps);
  EXPECT_EQ(elements, result.mesh.elements.size());
  EXPECT_EQ(recorder.steps.back().frontEdges, 0u);
}

TEST(Observer, HearsWhyEachOtherRuleWasRefused) {
  Recorder recorder(true);
  FrontOptions options;
  options.observer = &recorder;
  const MeshingResult result = run(discWithHole(.05), .05, options);
  ASSERT_EQ(recorder.refusals.size(), result.steps);
  for (std::size_t i = 0; i < recorder.steps.size(); ++i) {
    const StepReport& step = recorder.steps[i];
    std::vector<bool> isTold(12, false);
    for (const RuleRefusal& r : recorder.refusals[i]) {
      EXPECT_NE(r.reason, Refusal::None);
      EXPECT_FALSE(isTold.at(r.rule)) << "told twice";
      isTold[r.rule] = true;
      EXPECT_TRUE(step.applied || r.reason != Refusal::Beaten) << "beaten by nothing";
      const bool isHit = r.reason == Refusal::ZoneHitByVertex || r.reason == Refusal::ZoneHitByEdge;
      EXPECT_EQ(isHit, !r.from.isNone());
    }
    for (std::size_t rule = 0; rule < 12; ++rule)
      EXPECT_EQ(isTold[rule], !(step.applied && step.rule == rule));
  }
}

TEST(Observer, DoesNotChangeTheMesh) {
  const FrontInput input = discWithHole(.03);
  const MeshingResult plain = run(input, .03, {});
  for (bool wantsRefusals : {false, true}) {
    Recorder recorder(wantsRefusals);
    FrontOptions options;
    options.observer = &recorder;
    expectEqualResults(run(input, .03, options), plain);
  }
}

TEST(Progress, IsToldWhileALargeMeshIsMade) {
  std::vector<Progress> heard;
  FrontOptions options;
  options.progress = [&](const Progress& p) { heard.push_back(p); };
  const MeshingResult result = run(square(.01), .01, options);
  ASSERT_GE(heard.size(), 2u);
  for (std::size_t i = 1; i < heard.size(); ++i)
    EXPECT_GT(heard[i].elements, heard[i - 1].elements);
  EXPECT_LE(heard.back().elements, result.mesh.elements.size());
}

/// A run is given up by what it has examined: where very many edges are near, to look at them is
/// most of the work. This rule alone has one match a step.
TEST(Progress, CountsEdgesAsCandidatesWhereAFrontIsCrammed) {
  RuleSetDefinition set = triangleSetDefinition();
  set.rules = {freeTriangle()};
  const AF2Algorithm algorithm(std::make_shared<RuleSet>(set));
  const auto candidatesPerStep = [&](double side) {
    const FrontInput input = square(side);
    const MeshingResult result =
        algorithm.execute(FlatMaker(), input, UniformSize(1), FrontOptions{});
    return static_cast<double>(result.candidates) / static_cast<double>(result.steps);
  };
  EXPECT_LE(candidatesPerStep(0.1), 1);
  EXPECT_GT(candidatesPerStep(0.0025), 10);
}

/// Each zone is held against all that is near: with many matches that is the square of the crowd.
TEST(Progress, CountsWhatZonesAreHeldAgainstWhereAFrontIsCrammed) {
  FrontInput input = square(1);
  for (const Point2 place : circle({.5, .5}, .1, 5000))
    input.isolated.push_back(flatCorner(input.vertexCount++, place));
  const auto candidatesPerStep = [&](const std::vector<AF2Rule>& rules) {
    RuleSetDefinition set = triangleSetDefinition();
    set.rules = rules;
    const MeshingResult result = AF2Algorithm(std::make_shared<RuleSet>(set))
                                     .execute(FlatMaker(), input, UniformSize(1), FrontOptions{});
    return static_cast<double>(result.candidates) / static_cast<double>(result.steps);
  };
  const double one = candidatesPerStep({freeTriangle()});
  const double two = candidatesPerStep({freeTriangle(), freeTriangle()});
  EXPECT_GT(two - one, 100);
}

// ---- cancelling --------------------------------------------------------------------------------

TEST(Cancelling, BeforeTheRunGivesNoElements) {
  std::stop_source source;
  source.request_stop();
  FrontOptions options;
  options.stop = source.get_token();
  const FrontInput input = square(.1);
  const MeshingResult result = run(input, .1, options);
  EXPECT_EQ(result.outcome, Outcome::Cancelled);
  EXPECT_TRUE(result.mesh.elements.empty());
  EXPECT_EQ(result.mesh.vertices.size(), input.vertexCount);
}

TEST(Cancelling, FromAnotherThreadAnswersWithin100MillisecondsOfWorkWithTheMeshSoFar) {
  const FrontInput input = square(.0015);  // takes seconds
  std::stop_source source;
  FrontOptions options;
  options.stop = source.get_token();
  std::atomic<bool> isRunning = false;
  options.progress = [&](const Progress&) { isRunning = true; };
  // Of this process alone: how long it waits for others on the machine is not its fault.
  std::clock_t asked = 0;
  std::jthread canceller([&] {
    while (!isRunning) std::this_thread::yield();
    asked = std::clock();
    source.request_stop();
  });
  const MeshingResult result = run(input, .0015, options);
  const std::clock_t answered = std::clock();
  canceller.join();
  EXPECT_EQ(result.outcome, Outcome::Cancelled);
  EXPECT_LT(static_cast<double>(answered - asked) / CLOCKS_PER_SEC, .1);
  EXPECT_FALSE(result.mesh.elements.empty());
  EXPECT_EQ(result.mesh.origins.size(), result.mesh.elements.size());
  for (const MeshFault& fault : checkMesh(result.mesh, input))
    EXPECT_TRUE(fault.kind != MeshFault::Kind::Inverted &&
                fault.kind != MeshFault::Kind::BadElement &&
                fault.kind != MeshFault::Kind::OverlappingEdge)
        << describe(fault, result.mesh);
}

TEST(Cancelling, FromTheProgressCallbackOrTheObserverWorksToo) {
  std::stop_source source;
  class Stopper final : public AF2MeshingObserver {
   public:
    explicit Stopper(std::stop_source& s) : source_(s) {}
    void stepTaken(const StepReport& step) override {
      if (step.elements >= 10) source_.request_stop();
    }

   private:
    std::stop_source& source_;
  } stopper(source);
  FrontOptions options;
  options.stop = source.get_token();
  options.observer = &stopper;
  const MeshingResult result = run(square(.05), .05, options);
  EXPECT_EQ(result.outcome, Outcome::Cancelled);
  EXPECT_GE(result.mesh.elements.size(), 10u);
  EXPECT_LE(result.mesh.elements.size(), 13u) << "answered within a few steps";
}

// ---- getting stuck -----------------------------------------------------------------------------

TEST(Stuck, WithoutFillingRulesTellsWhereAndWhy) {
  const FrontInput input = square(.5);
  const auto set = setOf({freeTriangle(), flatTriangle(5, .5, .7)});
  const MeshingResult result = run(input, .5, {}, set);
  EXPECT_EQ(result.outcome, Outcome::Stuck);
  ASSERT_FALSE(result.stuck.empty());
  for (const StuckEdge& edge : result.stuck) {
    EXPECT_LT(edge.from.value, result.mesh.vertices.size());
    EXPECT_LT(edge.to.value, result.mesh.vertices.size());
    EXPECT_EQ(edge.level, set->maxLevel());
    ASSERT_EQ(edge.refusals.size(), 2u);
    for (const RuleRefusal& r : edge.refusals) {
      EXPECT_NE(r.reason, Refusal::None);
      EXPECT_NE(r.reason, Refusal::Beaten);
    }
  }
}

TEST(Stuck, KeepsTheMeshSoFarAndTheFrontThatIsLeft) {
  const FrontInput input = square(.25);
  const MeshingResult result = run(input, .25, {}, setOf({freeTriangle(), right60()}));
  ASSERT_EQ(result.outcome, Outcome::Stuck);
  EXPECT_FALSE(result.mesh.elements.empty());
  // What is meshed and what the front still bounds make up the square.
  double left = 0;
  for (const StuckEdge& e : result.stuck)
    left += .5 * cross(result.mesh.vertices[e.from.value].position,
                       result.mesh.vertices[e.to.value].position)
                     .z;
  EXPECT_NEAR(areaOf(result.mesh) + left, 1, 1e-12);
}

TEST(Stuck, AnImpatientRunEndsEarlyButNoEarlierThanItsFrontIsLong) {
  FrontInput input;
  addLoop(input, divided({{0, 0}, {40, 0}, {40, 1}, {0, 1}}, .02));
  const auto set = setOf({right60()});
  const MeshingResult patient = run(input, .02, {}, set);
  FrontOptions options;
  options.stallSteps = 3;
  const MeshingResult impatient = run(input, .02, options, set);
  EXPECT_EQ(patient.outcome, Outcome::Stuck);
  EXPECT_EQ(impatient.outcome, Outcome::Stuck);
  EXPECT_LE(impatient.mesh.elements.size(), patient.mesh.elements.size());
  EXPECT_LT(impatient.steps, patient.steps);
  EXPECT_GE(impatient.steps, 3 * impatient.stuck.size());
}

TEST(Stuck, ARunInVainEndsOnceItHasTakenWhatItMay) {
  FrontInput input;  // a square with a spike that is far longer than elements, and far narrower
  addLoop(input, divided({{0, 0}, {2, 0}, {2, 1}, {40, 1.001}, {2, 1.002}, {2, 2}, {0, 2}}, .2));
  const MeshingResult whole = run(input, .2, {}, triangleSet());
  FrontOptions options;
  options.stallCandidates = 1000;
  const MeshingResult ended = run(input, .2, options, triangleSet());
  EXPECT_EQ(whole.outcome, Outcome::Stuck);
  EXPECT_EQ(ended.outcome, Outcome::Stuck);
  EXPECT_GT(ended.mesh.elements.size(), 200u) << "the square is filled";
  EXPECT_LT(2 * ended.candidates, whole.candidates);
  options.stallCandidates = whole.candidates;
  EXPECT_EQ(run(input, .2, options, triangleSet()).mesh, whole.mesh);
}

/// Runs until it ends by itself, but not for ever.
Outcome outcomeOf(const FrontInput& input, double size) {
  std::stop_source source;
  FrontOptions options;
  options.stop = source.get_token();
  options.progress = [&](const Progress& p) {
    if (p.elements > 200000) source.request_stop();
  };
  try {
    return run(input, size, options).outcome;
  } catch (const InputError&) {
    return Outcome::Stuck;  // told before the run: just as good
  }
}

TEST(Stuck, WhereABoundaryCrossesItself) {
  // One lobe is bounded the wrong way round.
  for (double right : {1.0, .5, 2.0}) {
    FrontInput input;
    addLoop(input, divided({{0, 0}, {right, 1}, {right, 0}, {0, 1.5}}, .1));
    EXPECT_EQ(outcomeOf(input, .1), Outcome::Stuck) << "it never ends by itself";
  }
}

TEST(Stuck, WhereAHoleLiesOutside) {
  FrontInput input = square(.1);
  addLoop(input, circle({3, 0}, .3, 20, true));
  EXPECT_EQ(outcomeOf(input, .1), Outcome::Stuck) << "it never ends by itself";
}

TEST(Stuck, OnAnIsolatedVertexThatLiesOutside) {
  FrontInput input = square(.25);
  input.isolated.push_back(flatCorner(input.vertexCount++, {5, 5}));
  const MeshingResult result = run(input, .25, {});
  EXPECT_EQ(result.outcome, Outcome::Stuck);
  EXPECT_EQ(result.unused, std::vector<VertexId>{VertexId(input.vertexCount - 1)});
  EXPECT_TRUE(result.stuck.empty());
  EXPECT_NEAR(areaOf(result.mesh), 1, 1e-12);
}

TEST(Stuck, ExplainsTheFirstHundredEdges) {
  const FrontInput input = square(.01);
  const MeshingResult result = run(input, .01, {}, setOf({fillTriangle()}));
  ASSERT_EQ(result.outcome, Outcome::Stuck);
  ASSERT_EQ(result.stuck.size(), 400u);
  for (std::size_t i = 0; i < 400; ++i)
    EXPECT_EQ(result.stuck[i].refusals.size(), i < 100 ? 1u : 0u) << i;
}

// ---- determinism -------------------------------------------------------------------------------

TEST(Determinism, TwoRunsGiveEqualResults) {
  const FrontInput input = discWithHole(.02);
  const AF2Algorithm algorithm(triangleSet());
  const MeshingResult one = algorithm.execute(FlatMaker(), input, UniformSize(.02));
  expectEqualResults(algorithm.execute(FlatMaker(), input, UniformSize(.02)), one);
  expectEqualResults(meshFlat(input, .02), one);
}

TEST(Determinism, SeveralThreadsMayUseOneAlgorithm) {
  const FrontInput input = discWithHole(.02);
  const AF2Algorithm algorithm(triangleSet());
  const MeshingResult expected = algorithm.execute(FlatMaker(), input, UniformSize(.02));
  std::vector<MeshingResult> results(4);
  {
    std::vector<std::jthread> threads;
    for (MeshingResult& result : results)
      threads.emplace_back(
          [&] { result = algorithm.execute(FlatMaker(), input, UniformSize(.02)); });
  }
  for (const MeshingResult& result : results) expectEqualResults(result, expected);
}

TEST(Determinism, AMovedAlgorithmStaysItself) {
  AF2Algorithm one(triangleSet());
  const AF2Algorithm other(std::move(one));
  EXPECT_EQ(other.rules().name(), "triangles");
  const FrontInput input = square(.1);
  expectEqualResults(other.execute(FlatMaker(), input, UniformSize(.1)), meshFlat(input, .1));
}

}  // namespace
}  // namespace af2
