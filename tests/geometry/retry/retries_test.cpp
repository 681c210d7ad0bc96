#include "geometry/retry/retries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

namespace af2::geometry {
namespace {

/// Faces for which nothing helps: each front goes on as long as it may, at most for `kStubborn`
/// candidates.
class HopelessModel final : public RetriedModel {
 public:
  static constexpr std::size_t kStubborn = 3'000'000;

  explicit HopelessModel(std::size_t faces) : edges_(faces) {}

  const std::vector<std::vector<int>>& edgesOfFaces() const override { return edges_; }
  DividedEdges divide(const PositionSize&, const CollapsedEdges&) const override { return {}; }
  std::vector<CollapsedEdges> shortEdges(std::size_t, const DividedEdges&,
                                         const std::vector<SizeSource>&) const override {
    return {};
  }
  void mesh(std::size_t i, const PositionSize&, const TryLimits& limits,
            FaceMeshes& into) const override {
    into.meshes[i] = failure(i, std::min(limits.maxCandidates, kStubborn));
    spent += into.meshes[i].searchCost;
    if (limits.ignoresNormals) ++ignoring;
  }
  void join(FaceMeshes&) const override {}
  std::vector<SizeSource> sizesInside(std::size_t) const override { return {}; }

  static FaceMesh failure(std::size_t i, std::size_t searchCost) {
    FaceMesh mesh;
    mesh.report.id = static_cast<int>(i) + 1;
    mesh.report.status = FaceStatus::Failed;
    mesh.report.reason = "hopeless";
    mesh.diagnosis.isBad = true;
    mesh.diagnosis.places = {{{static_cast<double>(i), 0, 0}, 0.1}};
    mesh.searchCost = searchCost;
    return mesh;
  }

  mutable std::atomic<std::size_t> spent = 0, ignoring = 0;

 private:
  std::vector<std::vector<int>> edges_;
};

FaceMeshes retried(const HopelessModel& model, int threads) {
  FaceMeshes state;
  for (std::size_t i = 0; i < model.edgesOfFaces().size(); ++i)
    state.meshes.push_back(HopelessModel::failure(i, HopelessModel::kStubborn));
  RetryOptions options;
  options.largest = 1;
  options.threads = threads;
  retryPoorFaces(model, options, state);
  return state;
}

TEST(Retries, OfManyHopelessFacesTakeNoMoreThanOfAFew) {
  const HopelessModel few(5), many(200);
  retried(few, 1);
  const FaceMeshes state = retried(many, 2);
  EXPECT_LT(many.spent, 2 * few.spent);
  EXPECT_LT(many.spent, 60'000'000u);
  for (const FaceMesh& mesh : state.meshes) {
    ASSERT_FALSE(mesh.report.attempts.empty());
    EXPECT_EQ(mesh.report.attempts.back(),
              "not every remedy was tried: retries of failed faces have used up their budget");
  }
}

TEST(Retries, TakeAsMuchWithAnyNumberOfThreads) {
  const HopelessModel one(50), two(50);
  retried(one, 1);
  retried(two, 2);
  EXPECT_EQ(one.spent, two.spent);
  EXPECT_EQ(one.ignoring, two.ignoring);
}

TEST(Retries, LeaveSomethingForTheLastWayOfEachOfAFewFaces) {
  const HopelessModel model(5);
  retried(model, 1);
  EXPECT_EQ(model.ignoring, 5u);
}

/// Faces without edges, whose meshes depend on the sizes that are asked for.
class ModelOfSizes : public RetriedModel {
 public:
  static constexpr double kLargest = 1;

  explicit ModelOfSizes(std::size_t faces) : edges_(faces) {}

  const std::vector<std::vector<int>>& edgesOfFaces() const override { return edges_; }
  DividedEdges divide(const PositionSize& sizes, const CollapsedEdges&) const override {
    sizes_ = sizes;
    return {};
  }
  std::vector<CollapsedEdges> shortEdges(std::size_t, const DividedEdges&,
                                         const std::vector<SizeSource>&) const override {
    return {};
  }
  std::vector<SizeSource> sizesInside(std::size_t) const override { return {}; }

 protected:
  double sizeAt(const Point3& place) const {
    return sizes_ ? std::min(kLargest, sizes_.at(place)) : kLargest;
  }

 private:
  mutable PositionSize sizes_;
  std::vector<std::vector<int>> edges_;
};

/// Two faces all but touch along a line: they cross at the first place of it where elements are too
/// large, and when these are smaller, at the next one.
class TouchingModel final : public ModelOfSizes {
 public:
  static constexpr int kPlaces = 7;
  static constexpr double kWanted = 0.3;

  explicit TouchingModel(bool meet) : ModelOfSizes(2), meet_(meet) {}

  void mesh(std::size_t i, const PositionSize&, const TryLimits&, FaceMeshes& into) const override {
    into.meshes[i] = face(i);
    ++meshed;
  }
  bool meetsOthers(std::size_t, const std::vector<Crossing>&) const override { return meet_; }
  void join(FaceMeshes& state) const override {
    state.joined = {};
    state.faults = {};
    for (int k = 0; k < kPlaces && state.faults.crossings.empty(); ++k) {
      const Point3 place{static_cast<double>(k), 0, 0};
      const double size = sizeAt(place);
      if (size <= kWanted) continue;
      state.faults.crossings.push_back(
          {{ElementId(0), ElementId(0)}, {1, 2}, false, place, {size, size}});
    }
  }

  static FaceMesh face(std::size_t i) {
    FaceMesh mesh;
    mesh.report.id = static_cast<int>(i) + 1;
    mesh.searchCost = 1000;
    return mesh;
  }

  mutable std::atomic<std::size_t> meshed = 0;

 private:
  bool meet_;
};

FaceMeshes retried(const TouchingModel& model) {
  FaceMeshes state;
  for (std::size_t i = 0; i < 2; ++i) state.meshes.push_back(TouchingModel::face(i));
  RetryOptions options;
  options.largest = TouchingModel::kLargest;
  retryPoorFaces(model, options, state);
  return state;
}

TEST(Retries, GoOnAlongALineWhereFacesAllButTouch) {
  const TouchingModel model(false);
  EXPECT_TRUE(retried(model).faults.crossings.empty());
}

TEST(Retries, EndWhereFacesMeetInTheModel) {
  const TouchingModel model(true);
  EXPECT_FALSE(retried(model).faults.crossings.empty());
  EXPECT_LE(model.meshed, 2u * 2u) << "once with shorter edges, and once without";
}

/// A face that fails at more and more places, or at as many.
class StubbornModel final : public ModelOfSizes {
 public:
  explicit StubbornModel(std::size_t more) : ModelOfSizes(1), more_(more) {}

  void mesh(std::size_t, const PositionSize&, const TryLimits& limits,
            FaceMeshes& into) const override {
    into.meshes[0] = failure(1 + more_ * tries);
    if (!limits.ignoresNormals) ++tries;
  }
  void join(FaceMeshes&) const override {}

  static FaceMesh failure(std::size_t places) {
    FaceMesh mesh = HopelessModel::failure(0, 1000);
    mesh.diagnosis.places.resize(places, mesh.diagnosis.places.front());
    return mesh;
  }

  mutable std::size_t tries = 1;

 private:
  std::size_t more_;
};

TEST(Retries, EndOnceAFaceIsAtFaultAtMorePlaces) {
  const auto triesOf = [](std::size_t more) {
    const StubbornModel model(more);
    FaceMeshes state;
    state.meshes.push_back(StubbornModel::failure(1));
    RetryOptions options;
    options.largest = StubbornModel::kLargest;
    retryPoorFaces(model, options, state);
    return model.tries;
  };
  EXPECT_EQ(triesOf(1), 2u) << "the first mesh, and one with shorter edges";
  EXPECT_EQ(triesOf(0), 4u);
}

/// A face that has a mesh, though a poor one, only if its edges are short, and not too short.
class ParticularModel final : public ModelOfSizes {
 public:
  ParticularModel() : ModelOfSizes(1) {}

  void mesh(std::size_t, const PositionSize&, const TryLimits&, FaceMeshes& into) const override {
    into.meshes[0] = face(sizeAt({0, 0, 0}));
  }
  void join(FaceMeshes& state) const override {
    state.joined = {};
    state.faults = {};
  }

  static FaceMesh face(double size) {
    FaceMesh mesh;
    mesh.report.id = 1;
    mesh.diagnosis.isBad = true;
    mesh.diagnosis.places = {{{0, 0, 0}, 0.4 * size}};
    if (size > 0.5 || size < 0.2) {
      mesh.report.status = FaceStatus::Failed;
      mesh.report.reason = "edges too long or too short";
    } else {
      mesh.elements.resize(10);
      mesh.diagnosis.poorness = 0.5;
    }
    return mesh;
  }
};

TEST(Retries, DoNotLoseAMeshToWhatShouldMakeItBetter) {
  const ParticularModel model;
  FaceMeshes state;
  state.meshes.push_back(ParticularModel::face(ParticularModel::kLargest));
  RetryOptions options;
  options.largest = ParticularModel::kLargest;
  retryPoorFaces(model, options, state);
  EXPECT_EQ(state.meshes[0].report.status, FaceStatus::Complete);
  EXPECT_EQ(state.meshes[0].elements.size(), 10u);
}

}  // namespace
}  // namespace af2::geometry
