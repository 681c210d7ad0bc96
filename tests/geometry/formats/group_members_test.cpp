#include "geometry/formats/group_members.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/small_meshes.h"

namespace af2::geometry {
namespace {

TEST(GroupMembers, OverlapAsTheGroupsDo) {
  const ModelMesh mesh = cubeMesh();
  const std::vector<LineElement> lines = lineElements(mesh, LinesAlong::AllEdges);
  const MshGroups groups(mesh, {lines, {}}, {});
  const std::vector<GroupMembers> members = groupMembers(mesh, lines, groups);
  ASSERT_EQ(members.size(), 4u + 6u + 4u);
  EXPECT_EQ(members[3].name, "edge 4");
  EXPECT_EQ(members[3].members, (std::vector<std::uint32_t>{3}));
  EXPECT_EQ(members.back().name, "solid 1");
  EXPECT_EQ(members.back().members.size(), 11u);
  EXPECT_EQ(verticesOf(mesh, lines, members.back()).size(), 8u);
  EXPECT_EQ(verticesOf(mesh, lines, members[3]), (std::vector{VertexId(4), VertexId(7)}));
}

TEST(GroupMembers, AreInOneBlockEach) {
  const ModelMesh mesh = cubeMesh();
  const MshGroups groups(mesh, {}, {});
  const std::vector<ElementBlock> blocks = elementBlocks(mesh, groups);
  ASSERT_EQ(blocks.size(), 6u);
  EXPECT_TRUE(blocks[5].isQuad);
  EXPECT_EQ(blocks[5].elements, (std::vector<std::uint32_t>{10}));
}

TEST(GroupMembers, LieOnSidesOfElements) {
  const ModelMesh mesh = cubeMesh();
  const std::vector<LineElement> lines = lineElements(mesh, LinesAlong::AllEdges);
  const std::vector<ElementSide> sides = sidesOnLines(mesh, lines);
  ASSERT_EQ(sides.size(), 4u);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto corners = mesh.elements[sides[i].element].vertices();
    const VertexId from = corners[sides[i].side],
                   to = corners[(sides[i].side + 1) % corners.size()];
    EXPECT_EQ(std::minmax(from, to), std::minmax(lines[i].from, lines[i].to));
    EXPECT_LT(sides[i].element, 10u);  // of both the first, not the lid
  }
}

}  // namespace
}  // namespace af2::geometry
