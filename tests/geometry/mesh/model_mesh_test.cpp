#include "geometry/mesh/model_mesh.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/spooled.h"
#include "tests/support/strip.h"

namespace af2::geometry {
namespace {

std::vector<ElementRun> runsOf(const ModelMesh& mesh) {
  std::vector<ElementRun> runs;
  forEachRun(mesh, [&](const ElementRun& run) { runs.push_back(run); });
  return runs;
}

TEST(ElementRuns, AreOfOneFaceAndOneKind) {
  ModelMesh mesh = testing::strip({true, true, false, true, true, true, false, false, false}, 4);
  testing::outlineFaces(mesh, 4);
  const std::vector<ElementRun> expected{{1, false, 4}, {1, true, 1}, {1, false, 2},
                                         {2, false, 4}, {2, true, 2}, {3, true, 1}};
  EXPECT_EQ(runsOf(mesh), expected);
  const testing::BothMeshes both = testing::joined(testing::facesOf(mesh));
  ASSERT_TRUE(both.onDisk.spooled);
  EXPECT_EQ(runsOf(both.onDisk), expected);
  EXPECT_EQ(runsOf(ModelMesh()), std::vector<ElementRun>());
}

}  // namespace
}  // namespace af2::geometry
