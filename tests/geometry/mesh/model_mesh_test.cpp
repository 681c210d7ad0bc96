#include "geometry/mesh/model_mesh.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/spooled.h"

namespace af2::geometry {
namespace {

std::vector<ElementRun> runsOf(const ModelMesh& mesh) {
  std::vector<ElementRun> runs;
  forEachRun(mesh, [&](const ElementRun& run) { runs.push_back(run); });
  return runs;
}

/// A row of squares; those of some are divided in two triangles.
ModelMesh rowOf(const std::vector<bool>& areDivided) {
  ModelMesh mesh;
  const std::size_t squares = areDivided.size();
  for (std::size_t i = 0; i <= squares; ++i)
    for (const double y : {0.0, 1.0}) mesh.vertices.push_back({static_cast<double>(i), y, 0});
  for (std::size_t i = 0; i < squares; ++i) {
    const VertexId a(2 * i), b(2 * i + 2), c(2 * i + 3), d(2 * i + 1);
    if (areDivided[i]) {
      mesh.elements.push_back({{a, b, c, VertexId()}});
      mesh.elements.push_back({{a, c, d, VertexId()}});
    } else {
      mesh.elements.push_back({{a, b, c, d}});
    }
    mesh.segments.push_back({a, b, 1, 1, {}});
    mesh.segments.push_back({d, c, 1, 1, {}});
  }
  return mesh;
}

TEST(ElementRuns, AreOfOneFaceAndOneKind) {
  ModelMesh mesh = rowOf({true, true, false, true, true, true, false, false});
  //                      1     1     1      1     2     2     3      3
  mesh.face = {1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3};
  for (const int face : {1, 2, 3}) mesh.faces.emplace_back().id = face;
  for (const std::uint32_t x : {4u, 6u})
    mesh.segments.push_back({VertexId(2 * x), VertexId(2 * x + 1), 1, 2, {}});
  const std::vector<ElementRun> expected{
      {1, false, 4}, {1, true, 1}, {1, false, 2}, {2, false, 4}, {3, true, 2}};
  EXPECT_EQ(runsOf(mesh), expected);
  const testing::BothMeshes both = testing::joined(testing::facesOf(mesh));
  ASSERT_TRUE(both.onDisk.spooled);
  EXPECT_EQ(runsOf(both.onDisk), expected);
  EXPECT_EQ(runsOf(ModelMesh()), std::vector<ElementRun>());
}

}  // namespace
}  // namespace af2::geometry
