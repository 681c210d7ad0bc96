#include "geometry/io/line_elements.h"

#include <gtest/gtest.h>

#include "tests/support/small_meshes.h"

namespace af2::geometry {
namespace {

TEST(LineElements, LieAlongBoundariesOrAlongAllEdges) {
  ModelMesh mesh = cubeMesh();
  EXPECT_TRUE(lineElements(mesh, LinesAlong::Boundaries).empty());
  mesh.boundaries = {{7, "inlet", {2, 4}}};
  const std::vector<LineElement> marked = lineElements(mesh, LinesAlong::Boundaries);
  ASSERT_EQ(marked.size(), 2u);
  EXPECT_EQ(marked[0].edge, 2);
  EXPECT_EQ(marked[1].edge, 4);
  EXPECT_EQ(marked[1].boundary, 7);
  EXPECT_EQ(marked[1].from, mesh.segments[3].from);
  EXPECT_TRUE(marked[1].middle.isNone());
  const std::vector<LineElement> all = lineElements(mesh, LinesAlong::AllEdges);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].boundary, 0);
  EXPECT_EQ(all[1].boundary, 7);
}

TEST(LineElements, OfSecondOrderHaveTheMiddleThatTheElementsBesideHave) {
  ModelMesh mesh = oneElement({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.segments = {{VertexId(2), VertexId(1), 1, 1}};
  mesh.midsides = {{VertexId(3), VertexId(4), VertexId(5), VertexId()}};
  mesh.vertices.resize(6);
  const std::vector<LineElement> lines = lineElements(mesh, LinesAlong::AllEdges);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].from, VertexId(2));
  EXPECT_EQ(lines[0].middle, VertexId(4));
}

TEST(LineElements, AreSidesOfElements) {
  ModelMesh mesh = oneElement({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  mesh.segments = {{VertexId(0), VertexId(2), 1, 1}};  // of a face that failed
  EXPECT_TRUE(lineElements(mesh, LinesAlong::AllEdges).empty());
}

}  // namespace
}  // namespace af2::geometry
