#include "geometry/fill/stuck_front.h"

#include <gtest/gtest.h>

#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

TEST(StuckReason, IsThatOfTheFirstEdgeThatWasRefusedMostOften) {
  MeshingResult result;
  for (int i = 0; i < 5; ++i) result.mesh.vertices.push_back({{double(i), 0, 0}, {0, 0, 1}, 0, 0});
  const auto edge = [](std::uint32_t from, int level, Refusal reason) {
    return StuckEdge{VertexId(from), VertexId(from + 1), level, {{0, reason, {}, {}}}, {}};
  };
  const AF2Algorithm algorithm(testing::triangleSet());
  EXPECT_EQ(stuckReason(result, algorithm), "the front got stuck with 0 edges left");
  result.stuck = {edge(0, 3, Refusal::Beaten), edge(1, 7, Refusal::Pattern),
                  edge(2, 7, Refusal::Beaten), edge(3, 9, Refusal::Beaten)};
  result.stuck.back().refusals.clear();
  EXPECT_EQ(stuckReason(result, algorithm),
            "the front got stuck with 4 edges left, one from (1, 0, 0) to (2, 0, 0); rule '" +
                algorithm.rules().rules()[0].name() + "': " + toString(Refusal::Pattern));
}

}  // namespace
}  // namespace af2::geometry
