#include "geometry/fill/chart_way.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/charts/flat_surface.h"
#include "tests/support/meshing.h"

namespace af2::geometry {
namespace {

constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

/// Wants edges of half a unit along a square from (0, 0) to (4, 4), and tiny ones in its middle.
double fineInside(const Point3& p) {
  return std::clamp(0.4 * (std::hypot(p.x - 2, p.y - 2) - 0.8), 0.01, 0.5);
}

/// A plane that is not known as one, as a curved surface is where nothing bends it.
class UnknownPlane final : public ChartedSurface {
 public:
  bool isPlane() const override { return false; }
  bool has(ChartKind kind) const override { return plane_.has(kind); }
  std::unique_ptr<AF2LocalTransformMaker> makeCharts(ChartKind kind) const override {
    return plane_.makeCharts(kind);
  }
  SurfacePoint at(double u, double v) const override { return plane_.at(u, v); }

 private:
  FlatSurface plane_{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
};

/// What the task says beyond the boundary and the sizes.
struct Given {
  double area = 16, expectedElements = 1;
  bool knowsSizes = false;
  std::size_t maxCandidates = kAnyNumber;
  double areaBeside = 0;
  bool failedBefore = false;
  FinerInside finer = {};
};

/// Does something with the task to fill the square, divided into segments of that length.
template <class Use>
FaceAttempt with(const ChartedSurface& surface, const SizeField& size, const Given& given,
                 std::shared_ptr<const RuleSet> rules, double segment, Use&& use) {
  FaceBoundary boundary;
  testing::addLoop(boundary.input, testing::divided({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, segment));
  const AF2Algorithm algorithm(std::move(rules));
  FillOptions options;
  options.optimize = false;
  const ProgressCallback silent;
  const auto makeTools = [&](ChartKind kind) {
    return PieceTools{surface.makeCharts(kind), {&size, [](const SizeField*) {}}};
  };
  const TryLimits limits{.maxCandidates = given.maxCandidates, .failedBefore = given.failedBefore};
  const FaceTask task{
      surface,     boundary, size,   given.area, given.expectedElements, algorithm,       options,
      given.finer, limits,   silent, makeTools,  given.knowsSizes,       given.areaBeside};
  return use(task);
}

FaceAttempt attempt(const ChartedSurface& surface, const SizeField& size, const Given& given) {
  return with(surface, size, given, testing::triangleSet(), 0.5, [](const FaceTask& task) {
    return attemptWith(task, chartKinds().front(), FrontOptions{}.stallSteps);
  });
}

FaceAttempt attempt(const SizeField& size, const Given& given) {
  return attempt(FlatSurface({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), size, given);
}

TEST(ChartWay, GoesOnWhileAFrontMakesWhatIsExpected) {
  const FaceAttempt filled = attempt(UniformSize(0.5), {});
  EXPECT_TRUE(filled.fault.isNone());
  EXPECT_EQ(filled.result.outcome, Outcome::Complete);
}

TEST(ChartWay, EndsAFrontThatMakesFarMoreElementsThanItsBoundaryLetsExpect) {
  const FaceAttempt ended = attempt(SizeFunction(fineInside), {});
  EXPECT_EQ(ended.fault.kind, FillFaultKind::TooManyElements);
  EXPECT_TRUE(ended.result.stuck.empty());
  const std::string reason = textOf(ended.fault);
  EXPECT_NE(reason.find(std::to_string(ended.result.mesh.elements.size()) + " elements were made"),
            std::string::npos)
      << reason;
  EXPECT_NE(reason.find("most by 'free triangle"), std::string::npos) << reason;
  const FaceAttempt whole = attempt(SizeFunction(fineInside), {.expectedElements = 20'000});
  EXPECT_LT(2 * ended.result.mesh.elements.size(), whole.result.mesh.elements.size());
}

TEST(ChartWay, EndsAFrontThatMakesFarMoreElementsThanTheSizesInsideLetExpect) {
  EXPECT_EQ(attempt(SizeFunction(fineInside), {.expectedElements = 20'000}).fault.kind,
            FillFaultKind::None);
  EXPECT_EQ(
      attempt(SizeFunction(fineInside), {.expectedElements = 100, .knowsSizes = true}).fault.kind,
      FillFaultKind::TooManyElements);
}

/// A front that overlaps itself would go on for minutes otherwise.
TEST(ChartWay, EndsAFrontThatMakesFarMoreElementsThanSizesByPositionMayWant) {
  const auto faultWith = [](const FinerInside& finer) {
    return attempt(SizeFunction(fineInside), {.finer = finer}).fault.kind;
  };
  EXPECT_EQ(faultWith(kAnySizes), FillFaultKind::None);
  EXPECT_EQ(faultWith({.around = 20'000, .shareAtPoints = 1e9}), FillFaultKind::None);
  EXPECT_EQ(faultWith({.around = 100, .shareAtPoints = 1e9}), FillFaultKind::TooManyElements);
  EXPECT_EQ(faultWith({.around = 20'000, .shareAtPoints = 1}), FillFaultKind::TooManyElements);
  EXPECT_EQ(faultWith({.share = 1000}), FillFaultKind::None);
}

TEST(ChartWay, EndsAFrontOfAFaceOfUnknownAreaByTheElementsThatItMayHave) {
  EXPECT_EQ(attempt(SizeFunction(fineInside), {.area = 0, .expectedElements = 20'000}).fault.kind,
            FillFaultKind::None);
  EXPECT_EQ(attempt(SizeFunction(fineInside), {.area = 0}).fault.kind,
            FillFaultKind::TooManyElements);
}

TEST(ChartWay, EndsAFrontWhoseElementsHaveFarMoreAreaThanTheFace) {
  const SizeFunction fine(fineInside);
  const auto of = [](double area) { return Given{.area = area, .expectedElements = 20'000}; };
  const FaceAttempt whole = attempt(UnknownPlane(), fine, of(13));
  EXPECT_TRUE(whole.fault.isNone()) << textOf(whole.fault);
  const FaceAttempt ended = attempt(UnknownPlane(), fine, of(5));
  EXPECT_EQ(ended.fault.kind, FillFaultKind::TooMuchArea);
  const std::string reason = textOf(ended.fault);
  EXPECT_NE(reason.find(" times the area of the face, most by 'free triangle"), std::string::npos)
      << reason;
  EXPECT_LT(2 * ended.result.mesh.elements.size(), whole.result.mesh.elements.size());
  ASSERT_FALSE(ended.result.stuck.empty());
  for (const StuckEdge& edge : ended.result.stuck) EXPECT_GT(edge.level, 1);
  // Fans and layers beside it count on both sides.
  EXPECT_TRUE(
      attempt(UnknownPlane(), fine, {.area = 10, .expectedElements = 20'000, .areaBeside = 6})
          .fault.isNone());
  EXPECT_FALSE(attempt(UnknownPlane(), fine, of(10)).fault.isNone());
  // Planes cannot overlap themselves, and faces of unknown area cannot be compared.
  EXPECT_TRUE(attempt(fine, of(5)).fault.isNone());
  EXPECT_TRUE(attempt(UnknownPlane(), fine, of(0)).fault.isNone());
}

TEST(ChartWay, EndsAFrontThatDoesNotGetOnWithTheLastChartsWhereItFailedBefore) {
  const FlatSurface plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto steps = [&](bool failedBefore, AF2Rule onlyRule) {
    RuleSetDefinition definition = testing::triangleSetDefinition();
    definition.rules = {std::move(onlyRule)};
    const auto use = [](const FaceTask& task) {
      FillState state{task, {&chartKinds().front()}};
      EXPECT_EQ(fillThroughCharts(state).fault.kind, FillFaultKind::NotFilled);
      return std::move(state.failed.front());
    };
    const FaceAttempt ended = with(plane, UniformSize(0.02), {.failedBefore = failedBefore},
                                   std::make_shared<RuleSet>(std::move(definition)), 0.02, use);
    EXPECT_EQ(ended.result.outcome, Outcome::Stuck);
    EXPECT_EQ(ended.result.stuck.size(), 800u);
    return ended.result.steps;
  };
  const std::size_t whole = steps(false, testing::fillTriangle());
  EXPECT_LT(2 * steps(true, testing::fillTriangle()), whole);
  // A rule that comes late has its turn.
  EXPECT_GT(steps(true, testing::flatTriangle(30, -1, 9)), 30u * 800);
}

TEST(ChartWay, EndsAFrontThatExaminesMoreCandidatesThanItMay) {
  const FaceAttempt ended = attempt(UniformSize(0.05), {.maxCandidates = 500});
  EXPECT_EQ(ended.fault.kind, FillFaultKind::TooManyCandidates);
  EXPECT_LT(2 * ended.searchCost, attempt(UniformSize(0.05), {}).searchCost);
}

}  // namespace
}  // namespace af2::geometry
