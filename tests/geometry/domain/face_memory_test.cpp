#include "geometry/domain/face_memory.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <utility>

#include "geometry/faceted/mesh_faceted.h"
#include "tests/geometry/faceted/sheets.h"
#include "tests/support/model_mesh.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

using testing::Closed;
using testing::grid;

/// Counts how often charts are made.
class CountedSurface final : public ChartedSurface {
 public:
  CountedSurface(std::shared_ptr<const ChartedSurface> of, std::atomic<int>& count)
      : of_(std::move(of)), count_(count) {}
  SurfacePoint at(double u, double v) const override { return of_->at(u, v); }
  bool isPlane() const override { return of_->isPlane(); }
  bool has(ChartKind kind) const override { return of_->has(kind); }
  std::unique_ptr<AF2LocalTransformMaker> makeCharts(ChartKind kind) const override {
    ++count_;
    return of_->makeCharts(kind);
  }
  const ParametricSurface* inParameters() const override { return of_->inParameters(); }

 private:
  std::shared_ptr<const ChartedSurface> of_;
  std::atomic<int>& count_;
};

/// Two faces, a wave and a plane, that meet in a ridge.
class FaceMemoryOfModel : public ::testing::Test {
 protected:
  FaceMemoryOfModel() {
    options_.sizes.size = 0.3;
    const auto position = [](std::uint32_t i, std::uint32_t j) {
      const double x = i / 10.0, y = j / 10.0, beyond = x - 1.5;
      return beyond <= 0 ? Point3{x, y, x}
                         : Point3{x, y, 1.5 - beyond + 0.1 * std::sin(2 * beyond)};
    };
    model_ = facetedModel(grid(30, 30, Closed::InNeither, position), options_);
    model_.memory = std::make_shared<FaceMemory>();
    for (DomainFace& face : model_.faces)
      face.surface = std::make_shared<CountedSurface>(face.surface, charts_);
  }

  ModelMesh meshed() {
    charts_ = 0;
    return meshDomain(model_, algorithm_, options_);
  }

  static void expectSame(const ModelMesh& one, const ModelMesh& other) {
    EXPECT_EQ(one.vertices, other.vertices);
    EXPECT_EQ(one.wantedSizes, other.wantedSizes);
    ASSERT_EQ(one.elements.size(), other.elements.size());
    for (std::size_t i = 0; i < one.elements.size(); ++i)
      EXPECT_EQ(one.elements[i].corners, other.elements[i].corners);
    ASSERT_EQ(one.faces.size(), other.faces.size());
    for (std::size_t i = 0; i < one.faces.size(); ++i) {
      EXPECT_EQ(one.faces[i].id, other.faces[i].id);
      EXPECT_EQ(one.faces[i].surfaceType, other.faces[i].surfaceType);
      EXPECT_EQ(one.faces[i].area, other.faces[i].area);
      EXPECT_EQ(one.faces[i].chart, other.faces[i].chart);
      EXPECT_EQ(one.faces[i].elements, other.faces[i].elements);
      EXPECT_EQ(one.faces[i].attempts, other.faces[i].attempts);
      EXPECT_EQ(one.faces[i].reason, other.faces[i].reason);
    }
  }

  const AF2Algorithm algorithm_{testing::triangleSet()};
  MeshingOptions options_;
  DomainModel model_;
  std::atomic<int> charts_ = 0;
};

TEST_F(FaceMemoryOfModel, FillsAFaceOnceIfNothingChanges) {
  const ModelMesh first = meshed();
  testing::expectComplete(first);
  ASSERT_EQ(first.faces.size(), 2u);
  EXPECT_GT(charts_, 0);
  const ModelMesh second = meshed();
  EXPECT_EQ(charts_, 0);
  EXPECT_EQ(second.seconds.optimize, 0) << "it was spent before";
  expectSame(first, second);
}

TEST_F(FaceMemoryOfModel, FillsAFaceAnewIfItsSizesOrItsBoundaryChange) {
  const auto asWithoutMemory = [&] {
    const ModelMesh mesh = meshed();
    EXPECT_GT(charts_, 0);
    const auto memory = std::exchange(model_.memory, nullptr);
    expectSame(mesh, meshed());
    model_.memory = memory;
  };
  asWithoutMemory();
  options_.sizes.faceSizes[1] = 0.2;
  asWithoutMemory();
  options_.sizes.faceSizes.clear();
  options_.sizes.elementsPerTurn = 40;  // changes what curvature allows
  asWithoutMemory();
  options_.sizes.elementsPerTurn = 0;
  const DomainCurve& curve = model_.curves.front();
  options_.edgePoints[1] = {curve.pointAt(0.3 * curve.knots.back())};
  asWithoutMemory();
}

TEST_F(FaceMemoryOfModel, RemembersThatAFaceFailed) {
  options_.mostRetries = 0;
  options_.strictRules = true;
  options_.chart = ChartKind::MeanNormal;
  // A loop that begins twice is no boundary.
  for (DomainFace& face : model_.faces) face.loops.push_back(face.loops.front());
  const ModelMesh first = meshed();
  ASSERT_EQ(first.faces[0].status, FaceStatus::Failed);
  EXPECT_FALSE(first.faces[0].reason.empty());
  expectSame(first, meshed());
}

TEST(FaceMemory, FindsWhatWasKeptForTheSameNumbersOnTheSameSurface) {
  std::atomic<int> count = 0;
  const auto surface = std::make_shared<CountedSurface>(nullptr, count);
  const auto other = std::make_shared<CountedSurface>(nullptr, count);
  FaceMemory memory;
  const auto filled = std::make_shared<FaceMemory::Filled>();
  memory.keep({surface, {1, 2}}, filled);
  EXPECT_EQ(memory.find({surface, {1, 2}}), filled);
  EXPECT_EQ(memory.find({surface, {1, 3}}), nullptr);
  EXPECT_EQ(memory.find({surface, {1, 2, 3}}), nullptr);
  EXPECT_EQ(memory.find({other, {1, 2}}), nullptr);
}

TEST(FaceMemory, KeepsNoMoreElementsThanFit) {
  std::atomic<int> count = 0;
  const auto surface = std::make_shared<CountedSurface>(nullptr, count);
  FaceMemory memory;
  const auto large = std::make_shared<FaceMemory::Filled>();
  large->mesh.elements.resize(2'000'000);
  memory.keep({surface, {1}}, large);
  memory.keep({surface, {2}}, large);
  EXPECT_EQ(memory.find({surface, {1}}), large);
  EXPECT_EQ(memory.find({surface, {2}}), nullptr);
}

}  // namespace
}  // namespace af2::geometry
