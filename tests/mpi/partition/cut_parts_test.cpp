#include "geometry/mpi/partition/cut_parts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/mpi/partition/part_builder.h"
#include "geometry/mpi/partition/patch_graph.h"
#include "tests/support/spooled.h"
#include "tests/support/strip.h"

namespace af2::mpi {
namespace {

using geometry::ModelMesh;
using testing::strip;

std::vector<OwnedPart> partsOf(const ModelMesh& mesh, const MeshDivision& division,
                               std::span<const geometry::LineElement> lines = {}) {
  std::vector<PartBuilder> builders;
  for (int part = 0; part < division.parts; ++part) builders.emplace_back(part);
  std::vector<PartEnd> ends = cutParts(mesh, division, lines, [&](int part, PartPiece&& piece) {
    builders[static_cast<std::size_t>(part)].take(piece);
  });
  std::vector<OwnedPart> parts;
  for (std::size_t i = 0; i < builders.size(); ++i)
    parts.push_back(builders[i].finish(std::move(ends[i])));
  return parts;
}

/// Each patch of so many elements is a part.
std::vector<OwnedPart> partsOfPatches(const ModelMesh& mesh, std::size_t elements,
                                      std::span<const geometry::LineElement> lines = {}) {
  PatchGraph graph = patchGraph(mesh, elements);
  std::vector<std::int32_t> parts(graph.elements.size());
  for (std::size_t p = 0; p < parts.size(); ++p) parts[p] = static_cast<std::int32_t>(p);
  const auto count = static_cast<int>(parts.size());
  return partsOf(mesh, divisionInto(count, std::move(parts), std::move(graph)), lines);
}

TEST(CutParts, HaveTheElementsAtTheirVerticesAsGhosts) {
  const OwnedPart part = partsOfPatches(strip(4), 4).at(1);
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

TEST(CutParts, GiveALineToTheOwnerOfTheElementBesideIt) {
  const std::vector<geometry::LineElement> lines{{VertexId(0), VertexId(2), {}, 3, 0},
                                                 {VertexId(4), VertexId(2), {}, 3, 0}};
  const std::vector<OwnedPart> parts = partsOfPatches(strip(2), 2, lines);
  ASSERT_EQ(parts.at(0).lines.size(), 1u);
  EXPECT_EQ(parts[0].lines[0].id, 0u);
  const OwnedPart& part = parts.at(1);
  ASSERT_EQ(part.lines.size(), 1u);
  EXPECT_EQ(part.lines[0].id, 1u);
  EXPECT_EQ(part.vertexIds[part.lines[0].from.value], 4u);
}

/// Vertex 4 is at the corners of three faces and of all three parts.
TEST(CutParts, KnowGhostsInOtherFaces) {
  ModelMesh mesh = strip(3, 1);
  auto& corners = mesh.elements[2].corners;
  std::rotate(corners.begin(), corners.begin() + 1,
              corners.begin() + 3);  // beside the last part first
  const std::vector<OwnedPart> parts = partsOfPatches(mesh, 2);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[1].elementIds, (std::vector<std::uint64_t>{2, 3, 0, 1, 4, 5}));
  EXPECT_EQ(parts[1].face, (std::vector<std::int32_t>{2, 2, 1, 1, 3, 3}));
  EXPECT_EQ(parts[1].ghostsBegin, (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_EQ(parts[1].ghostsOf, (std::vector<std::int32_t>{0, 2, 0, 2}));
}

TEST(CutParts, GiveVerticesWithoutElementsToTheFirst) {
  ModelMesh mesh = strip(2);
  mesh.vertices.push_back({9, 9, 9});
  const std::vector<OwnedPart> parts = partsOfPatches(mesh, 2);
  EXPECT_EQ(parts[0].allVertices, 7u);
  EXPECT_EQ(parts[0].vertexIds, (std::vector<std::uint64_t>{0, 1, 2, 3, 6, 4, 5}));
  EXPECT_EQ(parts[0].ownedVertices, 5u);
}

TEST(CutParts, OfALargeFaceComeInSeveralPieces) {
  const ModelMesh mesh = strip(50'000, 50'000);
  PatchGraph graph = patchGraph(mesh, 50'000);
  const MeshDivision division = divisionInto(2, {0, 1}, std::move(graph));
  std::vector<PartBuilder> builders{PartBuilder(0), PartBuilder(1)};
  std::size_t pieces = 0, most = 0;
  const std::vector<PartEnd> ends = cutParts(mesh, division, {}, [&](int part, PartPiece&& piece) {
    ++pieces;
    most = std::max(most, piece.elements.size());
    builders[static_cast<std::size_t>(part)].take(piece);
  });
  EXPECT_GE(pieces, 6u);
  EXPECT_LE(most, 20'000u);
  const OwnedPart part = builders[1].finish(ends[1]);
  EXPECT_EQ(part.ownedElements, 50'000u);
  EXPECT_EQ(part.elements.size(), 50'002u);
  EXPECT_TRUE(std::ranges::is_sorted(std::span(part.elementIds).first(part.ownedElements)));
  EXPECT_EQ(part.vertices.size(), 50'004u) << "a vertex of several pieces is there once";
}

/// The same parts, whether the mesh is in memory or loaded face by face.
TEST(CutParts, OfAMeshOnDiskAreTheSame) {
  ModelMesh mesh = strip(60, 20);
  testing::outlineFaces(mesh, 20);
  const testing::BothMeshes both = testing::joined(testing::facesOf(mesh));
  ASSERT_TRUE(both.onDisk.spooled);
  ASSERT_TRUE(both.onDisk.elements.empty());
  const std::vector<OwnedPart> inMemory = partsOf(both.inMemory, divideMesh(both.inMemory, 3));
  const std::vector<OwnedPart> onDisk = partsOf(both.onDisk, divideMesh(both.onDisk, 3));
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_GT(inMemory[p].ownedElements, 30u);
    EXPECT_EQ(inMemory[p].vertices, onDisk[p].vertices);
    EXPECT_EQ(inMemory[p].vertexIds, onDisk[p].vertexIds);
    EXPECT_EQ(inMemory[p].vertexNumbers, onDisk[p].vertexNumbers);
    EXPECT_EQ(inMemory[p].vertexOwners, onDisk[p].vertexOwners);
    EXPECT_EQ(inMemory[p].elements, onDisk[p].elements);
    EXPECT_EQ(inMemory[p].elementIds, onDisk[p].elementIds);
    EXPECT_EQ(inMemory[p].elementNumbers, onDisk[p].elementNumbers);
    EXPECT_EQ(inMemory[p].ghostsOf, onDisk[p].ghostsOf);
  }
}

}  // namespace
}  // namespace af2::mpi
