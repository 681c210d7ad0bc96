#include <gtest/gtest.h>

#include <array>

#include "geometry/retry/retries.h"

namespace af2::geometry {
namespace {

/// Three faces in a row, between edges 1 to 4 at as many places. The first one is poor as long as
/// the size is more than a tenth at edge 1.
class RowModel final : public RetriedModel {
 public:
  static constexpr double kLargest = 1, kWanted = 0.1;

  const std::vector<std::vector<int>>& edgesOfFaces() const override { return edges_; }
  DividedEdges divide(const PositionSize& sizes, const CollapsedEdges&) const override {
    DividedEdges divided;
    for (int edge = 1; edge <= 4; ++edge)
      divided.edges.emplace_back().parameters = {0, sizeAtEdge(sizes, edge)};
    return divided;
  }
  std::vector<CollapsedEdges> shortEdges(std::size_t, const DividedEdges&,
                                         const std::vector<SizeSource>&) const override {
    return {};
  }
  void mesh(std::size_t i, const PositionSize&, const TryLimits&, FaceMeshes& into) const override {
    ++meshed[i];
    const auto sizeAt = [&](std::size_t edge) { return into.divided.edges[edge].parameters[1]; };
    FaceMesh& mesh = into.meshes[i] = FaceMesh();
    mesh.report.id = static_cast<int>(i) + 1;
    mesh.searchCost = 1000;
    if (i == 0 && (sizeAt(0) > kWanted || isHopeless)) {
      mesh.diagnosis.poorness = 1;
      mesh.diagnosis.places = {{{1, 0, 0}, kWanted}};
    }
    if (i == 1 && sizeAt(1) < kLargest && isSecondSpoiled) {
      mesh.report.status = FaceStatus::Failed;
      mesh.report.reason = "its edges are too short";
    }
  }
  void join(FaceMeshes& state) const override {
    EXPECT_TRUE(state.isComplete());
    ++joined;
  }
  std::vector<SizeSource> sizesInside(std::size_t) const override { return {}; }

  /// With the given faces waiting.
  FaceMeshes retried(std::vector<bool> isWaiting) const {
    FaceMeshes state;
    state.divided = divide({}, {});
    state.meshes.resize(3);
    for (std::size_t i = 0; i < 3; ++i)
      if (!isWaiting[i]) mesh(i, {}, {}, state);
    state.isWaiting = std::move(isWaiting);
    RetryOptions options;
    options.largest = kLargest;
    options.threads = 1;
    retryPoorFaces(*this, options, state);
    EXPECT_TRUE(state.isComplete());
    return state;
  }

  bool isHopeless = false, isSecondSpoiled = false;
  mutable std::array<int, 3> meshed{};
  mutable int joined = 0;

 private:
  static double sizeAtEdge(const PositionSize& sizes, int edge) {
    return sizes ? std::min(kLargest, sizes.at({static_cast<double>(edge), 0, 0})) : kLargest;
  }

  std::vector<std::vector<int>> edges_{{1, 2}, {2, 3}, {3, 4}};
};

TEST(Drafts, LetFacesWaitUntilTheEdgesAreSettled) {
  const RowModel model;
  const FaceMeshes state = model.retried({false, true, true});
  EXPECT_EQ(state.divided.edges[0].parameters[1], RowModel::kWanted);
  EXPECT_EQ(model.meshed, (std::array{2, 1, 1}));
  EXPECT_EQ(model.joined, 1);
}

TEST(Drafts, LeadToTheSameAsIfNoFaceHadWaited) {
  const RowModel waiting, meshed;
  const FaceMeshes one = waiting.retried({false, true, true}),
                   other = meshed.retried({false, false, false});
  for (std::size_t e = 0; e < 4; ++e)
    EXPECT_EQ(one.divided.edges[e].parameters, other.divided.edges[e].parameters);
  EXPECT_EQ(one.meshes[0].report.attempts, other.meshes[0].report.attempts);
  EXPECT_EQ(meshed.meshed, (std::array{2, 2, 2}));
}

TEST(Drafts, MeshNoNeighborForWhatDoesNotHelp) {
  RowModel model;
  model.isHopeless = true;
  const FaceMeshes state = model.retried({false, false, false});
  EXPECT_EQ(state.divided.edges[0].parameters[1], RowModel::kLargest);
  EXPECT_EQ(model.meshed, (std::array{2, 1, 1}));
  EXPECT_EQ(model.joined, 1);
  ASSERT_EQ(state.meshes[0].report.attempts.size(), 1u) << "the report names what was tried";
}

TEST(Drafts, MeshFacesThatWaitedWithTheFirstEdgesWhereNothingIsAsked) {
  RowModel model;
  const FaceMeshes state = model.retried({true, true, false});
  EXPECT_EQ(state.divided.edges[0].parameters[1], RowModel::kWanted);
  EXPECT_EQ(model.meshed, (std::array{2, 2, 2}));
}

TEST(Drafts, WithdrawWhatSpoilsAFaceThatWaited) {
  RowModel model;
  model.isSecondSpoiled = true;
  const FaceMeshes state = model.retried({false, true, true});
  EXPECT_FALSE(failed(state.meshes[1]));
  EXPECT_EQ(state.divided.edges[1].parameters[1], RowModel::kLargest);
}

}  // namespace
}  // namespace af2::geometry
