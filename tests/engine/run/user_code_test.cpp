// What size fields, observers and makers of charts that users bring may do to a run.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "engine/base/error.h"
#include "engine/mesh/element_area.h"
#include "engine/run/algorithm.h"
#include "tests/support/meshing.h"
#include "tests/support/recorded_run.h"

namespace af2 {
namespace {

using namespace af2::testing;

struct UserError : std::runtime_error {
  UserError() : std::runtime_error("user") {}
};

TEST(UserCode, ExceptionsOfASizeFieldReachTheCaller) {
  const AF2Algorithm algorithm(triangleSet());
  const FrontInput input = square(.1);
  int calls = 0;
  const SizeFunction failing([&](const Point3&) -> double {
    if (++calls > 60) throw UserError();
    return .1;
  });
  EXPECT_THROW(algorithm.execute(FlatMaker(), input, failing), UserError);
  expectGoodMesh(algorithm.execute(FlatMaker(), input, UniformSize(.1)), input, .1);
}

TEST(UserCode, SizesThatAreNotPositiveAreInputErrors) {
  const AF2Algorithm algorithm(triangleSet());
  for (double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                     std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(algorithm.execute(FlatMaker(), square(.1), UniformSize(bad)), InputError);
    int calls = 0;
    const SizeFunction inside([&](const Point3&) { return ++calls > 60 ? bad : .1; });
    EXPECT_THROW(algorithm.execute(FlatMaker(), square(.1), inside), InputError);
  }
}

TEST(UserCode, ExceptionsOfAnObserverReachTheCaller) {
  class Thrower final : public AF2MeshingObserver {
    void stepTaken(const StepReport&) override { throw UserError(); }
  } thrower;
  FrontOptions options;
  options.observer = &thrower;
  EXPECT_THROW(run(square(.1), .1, options), UserError);
}

TEST(UserCode, ExceptionsOfTheProgressCallbackReachTheCaller) {
  FrontOptions options;
  options.progress = [](const Progress&) { throw UserError(); };
  EXPECT_THROW(run(square(.01), .01, options), UserError);
}

/// Finds new points on the base edge, inside by what rounding leaves.
class FlatteningMaker final : public AF2LocalTransformMaker {
 public:
  std::unique_ptr<AF2LocalTransform> makeLocalTransform(const SurfacePoint& from,
                                                        const SurfacePoint& to,
                                                        double unit) const override {
    return std::make_unique<Chart>(from.position, to.position, unit);
  }

 private:
  class Chart final : public AF2LocalTransform {
   public:
    Chart(const Point3& from, const Point3& to, double unit)
        : from_(from), along_(to - from), flat_(flatChart(from, to, unit)) {}
    ChartPoint transformFromSurface(const SurfacePoint& p) const override {
      return flat_.transformFromSurface(p);
    }
    std::optional<SurfacePoint> transformToSurface(Point2) const override {
      constexpr double kRounding = 1e-16;
      const Point3 normal{0, 0, 1};
      return SurfacePoint{from_ + 0.5 * along_ + kRounding * cross(normal, along_), normal, 0, 0};
    }

   private:
    Point3 from_, along_;
    PlaneChart flat_;
  };
};

TEST(UserCode, APointOnTheBaseMakesNoElement) {
  const MeshingResult result =
      AF2Algorithm(triangleSet()).execute(FlatteningMaker(), square(.1), UniformSize(.1));
  EXPECT_EQ(result.outcome, Outcome::Stuck);
  for (const Element& element : result.mesh.elements) EXPECT_GT(areaOf(result.mesh, element), 1e-6);
}

/// Fails in a part of the plane, in one way or another.
class PartialMaker final : public AF2LocalTransformMaker {
 public:
  enum class Failure { Throws, ThrowsOther, NoSurface, NonFinite };
  explicit PartialMaker(Failure failure) : failure_(failure) {}
  std::unique_ptr<AF2LocalTransform> makeLocalTransform(const SurfacePoint& from,
                                                        const SurfacePoint& to,
                                                        double unit) const override {
    const bool isBad = from.position.x > .5;
    if (isBad && failure_ == Failure::Throws) throw GeometryError("no normal here");
    if (isBad && failure_ == Failure::ThrowsOther) throw UserError();
    return std::make_unique<Chart>(from.position, to.position, unit, failure_);
  }

 private:
  class Chart final : public AF2LocalTransform {
   public:
    Chart(const Point3& from, const Point3& to, double unit, Failure failure)
        : flat_(flatChart(from, to, unit)), failure_(failure) {}
    ChartPoint transformFromSurface(const SurfacePoint& p) const override {
      return flat_.transformFromSurface(p);
    }
    std::optional<SurfacePoint> transformToSurface(Point2 p) const override {
      const auto point = flat_.transformToSurface(p);
      if (point->position.x <= .5) return point;
      if (failure_ == Failure::NoSurface) return std::nullopt;
      const double nan = std::numeric_limits<double>::quiet_NaN();
      return SurfacePoint{{nan, nan, nan}, {0, 0, 1}, 0, 0};
    }

   private:
    PlaneChart flat_;
    Failure failure_;
  };
  Failure failure_;
};

MeshingResult runPartly(PartialMaker::Failure failure) {
  return AF2Algorithm(triangleSet()).execute(PartialMaker(failure), square(.1), UniformSize(.1));
}

TEST(UserCode, AGeometryErrorOfTheMakerIsAPlaceWithoutAChart) {
  const MeshingResult result = runPartly(PartialMaker::Failure::Throws);
  ASSERT_EQ(result.outcome, Outcome::Stuck);
  EXPECT_FALSE(result.mesh.elements.empty());
  for (const StuckEdge& edge : result.stuck)
    if (result.mesh.vertices[edge.from.value].position.x > .5) {
      ASSERT_EQ(edge.refusals.size(), 12u);
      for (const RuleRefusal& r : edge.refusals) EXPECT_EQ(r.reason, Refusal::Surface);
    }
}

TEST(UserCode, OtherExceptionsOfTheMakerReachTheCaller) {
  EXPECT_THROW(runPartly(PartialMaker::Failure::ThrowsOther), UserError);
}

TEST(UserCode, APointWithoutAFinitePlaceOnTheSurfaceRefusesTheRule) {
  using Failure = PartialMaker::Failure;
  for (Failure failure : {Failure::NoSurface, Failure::NonFinite}) {
    Recorder recorder(true);
    FrontOptions options;
    options.observer = &recorder;
    const FrontInput input = square(.1);
    // Rules that need no new vertex may still fill the region.
    const MeshingResult result =
        AF2Algorithm(triangleSet()).execute(PartialMaker(failure), input, UniformSize(.1), options);
    bool isTold = false;
    for (const auto& refusals : recorder.refusals)
      for (const RuleRefusal& r : refusals) isTold = isTold || r.reason == Refusal::Surface;
    EXPECT_TRUE(isTold);
    for (std::size_t v = input.vertexCount; v < result.mesh.vertices.size(); ++v)
      EXPECT_LE(result.mesh.vertices[v].position.x, .5);
  }
}

}  // namespace
}  // namespace af2
