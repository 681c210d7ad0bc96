#include "geometry/mpi/partition/cut_part.h"

#include <gtest/gtest.h>

namespace af2::mpi {
namespace {

using geometry::ModelMesh;

/// A strip of squares, of which each is cut in two triangles.
ModelMesh strip(std::size_t squares) {
  ModelMesh mesh;
  for (std::size_t i = 0; i <= squares; ++i)
    for (const double y : {0.0, 1.0}) mesh.vertices.push_back({static_cast<double>(i), y, 0});
  for (std::size_t i = 0; i < squares; ++i) {
    const VertexId a(2 * i), b(2 * i + 2), c(2 * i + 3), d(2 * i + 1);
    mesh.elements.push_back({{a, b, c, VertexId()}});
    mesh.elements.push_back({{a, c, d, VertexId()}});
  }
  mesh.face.assign(mesh.elements.size(), 1);
  return mesh;
}

TEST(DivideMesh, MakesPartsOfAboutTheSameSizeTheSameEachTime) {
  const ModelMesh mesh = strip(100);
  const std::vector<std::int32_t> owners = divideMesh(mesh, 4);
  EXPECT_EQ(owners, divideMesh(mesh, 4));
  for (int part = 0; part < 4; ++part) {
    EXPECT_GT(std::ranges::count(owners, part), 40);
    EXPECT_LT(std::ranges::count(owners, part), 60);
  }
}

TEST(DivideMesh, LeavesPartsEmptyWhereThereAreMoreThanElements) {
  EXPECT_EQ(divideMesh(strip(1), 5), (std::vector<std::int32_t>{0, 1}));
}

TEST(CutPart, HasTheElementsAtItsVerticesAsGhosts) {
  const ModelMesh mesh = strip(4);
  const DividedMesh divided(mesh, {0, 0, 0, 0, 1, 1, 1, 1}, 2);
  const OwnedPart part = cutPart(divided, {}, {}, 1);
  EXPECT_EQ(part.ownedElements, 4u);
  EXPECT_EQ(part.elementIds, (std::vector<std::uint64_t>{4, 5, 6, 7, 2, 3}));
  EXPECT_EQ(part.elementOwners, (std::vector<std::int32_t>{1, 1, 1, 1, 0, 0}));
  // Vertices 4 and 5 lie between the parts and belong to the first.
  EXPECT_EQ(part.vertexIds, (std::vector<std::uint64_t>{6, 7, 8, 9, 2, 3, 4, 5}));
  EXPECT_EQ(part.ownedVertices, 4u);
  EXPECT_EQ(part.vertexNumbers, (std::vector<std::uint64_t>{6, 7, 8, 9, 2, 3, 4, 5}));
  EXPECT_EQ(part.elements[0].corners[0].value, 6u) << "the index of vertex 4";
  EXPECT_EQ(part.ghostsBegin, (std::vector<std::size_t>{0, 1, 2, 2, 2}));
  EXPECT_EQ(part.ghostsOf, (std::vector<std::int32_t>{0, 0}));
}

TEST(CutPart, GivesALineToTheOwnerOfTheElementBesideIt) {
  const ModelMesh mesh = strip(2);
  const DividedMesh divided(mesh, {0, 0, 1, 1}, 2);
  const std::vector<geometry::LineElement> lines{{VertexId(0), VertexId(2), {}, 3, 0},
                                                 {VertexId(4), VertexId(2), {}, 3, 0}};
  const std::vector<std::int32_t> owners = ownersOfLines(divided, lines);
  EXPECT_EQ(owners, (std::vector<std::int32_t>{0, 1}));
  const OwnedPart part = cutPart(divided, lines, owners, 1);
  ASSERT_EQ(part.lines.size(), 1u);
  EXPECT_EQ(part.lines[0].id, 1u);
  EXPECT_EQ(part.vertexIds[part.lines[0].from.value], 4u);
}

}  // namespace
}  // namespace af2::mpi
