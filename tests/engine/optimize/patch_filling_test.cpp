// That regions around irregular vertices become regular, and that they follow boundaries.
#include "engine/optimize/patch_filling.h"

#include <gtest/gtest.h>

#include "engine/mesh/mesh_check.h"
#include "engine/optimize/quad_region.h"
#include "tests/support/meshing.h"
#include "tests/support/quad_grid.h"

namespace af2 {
namespace {

using namespace af2::testing;

/// A grid with an editor of its mesh.
struct EditedGrid {
  QuadGrid grid;
  MeshTopology topology;
  FlatMaker maker;
  PatchEditor editor;

  explicit EditedGrid(QuadGrid made)
      : grid(std::move(made)),
        topology(grid.mesh, boundaryOf(grid.input)),
        editor(topology, maker, topology.anglesAtFixed()) {}
};

std::size_t countIrregular(const EditedGrid& edited) {
  std::size_t count = 0;
  for (std::size_t v = 0; v < edited.grid.mesh.vertices.size(); ++v)
    count += edited.editor.irregularity(VertexId(v)) > 0 ? 1 : 0;
  return count;
}

/// The side between the squares (i, j) and (i + 1, j), rotated.
void rotateSide(QuadGrid& grid, int i, int j) {
  const VertexId a = grid.id(i, j), b = grid.id(i + 1, j), c = grid.id(i + 2, j),
                 d = grid.id(i + 2, j + 1), e = grid.id(i + 1, j + 1), f = grid.id(i, j + 1);
  grid.element(i, j) = {{a, b, c, d}};
  grid.element(i + 1, j) = {{d, e, f, a}};
  grid.mesh.vertices[b.value].position.y -= 0.4;
  grid.mesh.vertices[e.value].position.y += 0.4;
}

TEST(PatchFilling, LeavesARegularGridAsItIs) {
  EditedGrid edited(QuadGrid(5));
  const Mesh before = edited.grid.mesh;
  EXPECT_EQ(fillPatches(edited.editor, kGoodFilling, {}), 0u);
  EXPECT_EQ(edited.grid.mesh, before);
}

TEST(PatchFilling, MakesAGridOfAHeap) {
  QuadGrid grid(10);
  rotateSide(grid, 3, 3);
  rotateSide(grid, 5, 5);
  rotateSide(grid, 2, 6);
  EditedGrid edited(std::move(grid));
  EXPECT_EQ(countIrregular(edited), 12u);
  EXPECT_GE(fillPatches(edited.editor, kGoodFilling, {}), 1u);
  EXPECT_EQ(countIrregular(edited), 0u);
  edited.topology.compact();
  EXPECT_TRUE(checkMesh(edited.grid.mesh, edited.grid.input).empty());
  EXPECT_NEAR(areaOf(edited.grid.mesh), 100, 1e-9);
  EXPECT_EQ(edited.grid.mesh.elements.size(), 100u);
}

TEST(PatchFilling, StopsOnRequest) {
  QuadGrid grid(10);
  rotateSide(grid, 3, 3);
  EditedGrid edited(std::move(grid));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(fillPatches(edited.editor, kGoodFilling, stop.get_token()), 0u);
}

TEST(QuadRegion, OfARegularStarHasFourCorners) {
  EditedGrid edited(QuadGrid(6));
  QuadRegion region(edited.editor, 60);
  region.addStar(edited.grid.id(3, 3));
  ASSERT_TRUE(region.makeConvex());
  const auto ring = region.ring();
  ASSERT_TRUE(ring);
  EXPECT_EQ(region.elements().size(), 4u);
  EXPECT_EQ(ring->vertices.size(), 8u);
  EXPECT_EQ(ring->corners.size(), 4u);
}

TEST(QuadRegion, GrowsWhereItIsNotConvex) {
  EditedGrid edited(QuadGrid(8));
  QuadRegion region(edited.editor, 60);
  region.addStar(edited.grid.id(2, 2));
  region.addStar(edited.grid.id(4, 3));
  ASSERT_TRUE(region.makeConvex());
  EXPECT_EQ(region.elements().size(), 12u);  // 4 x 3
  EXPECT_EQ(region.ring()->corners.size(), 4u);
  region.addLayer();
  ASSERT_TRUE(region.makeConvex());
  EXPECT_EQ(region.elements().size(), 30u);
}

/// At a corner of the grid, where the outline has one quadrilateral at each of four vertices.
TEST(QuadRegion, ReachesTheBoundary) {
  EditedGrid edited(QuadGrid(4));
  QuadRegion region(edited.editor, 60);
  region.addStar(edited.grid.id(1, 1));
  ASSERT_TRUE(region.makeConvex());
  EXPECT_EQ(region.elements().size(), 4u);
  EXPECT_EQ(region.ring()->corners.size(), 4u);
}

TEST(QuadRegion, HasNoTriangles) {
  QuadGrid grid(6);
  grid.split(2, 2);
  EditedGrid edited(std::move(grid));
  QuadRegion region(edited.editor, 60);
  region.addStar(edited.grid.id(2, 2));
  EXPECT_FALSE(region.makeConvex());
}

}  // namespace
}  // namespace af2
