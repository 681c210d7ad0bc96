// Which volumes a mesh encloses: materials, voids, solids inside others.
#include "geometry/volumes/mesh_volumes.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "geometry/volumes/mesh_cells.h"

namespace af2::geometry {
namespace {

struct Block {
  Point3 low, high;
};

bool isStrictlyIn(const Block& block, const Point3& p) {
  return block.low.x < p.x && p.x < block.high.x && block.low.y < p.y && p.y < block.high.y &&
         block.low.z < p.z && p.z < block.high.z;
}

enum class Looks { Outwards, Inwards };

/// Blocks and plates, which share their vertices where they touch.
class BlockMesh {
 public:
  /// The faces first, ..., first + 5 look to -x, +x, -y, +y, -z, +z (or the other way).
  void add(const Block& block, int first, Looks looks = Looks::Outwards) {
    for (int axis = 0; axis < 3; ++axis)
      for (const int end : {0, 1}) {
        const bool isTurned = (end == 0) == (looks == Looks::Outwards);
        addSide(block, axis, end, first + 2 * axis + end, isTurned);
      }
  }
  void addSide(const Block& block, int axis, int end, int face, bool isTurned) {
    const auto at = [&](int i, int j) {
      std::array<int, 3> ends{};
      ends[static_cast<std::size_t>(axis)] = end;
      ends[static_cast<std::size_t>((axis + 1) % 3)] = i;
      ends[static_cast<std::size_t>((axis + 2) % 3)] = j;
      return vertex({(ends[0] ? block.high : block.low).x, (ends[1] ? block.high : block.low).y,
                     (ends[2] ? block.high : block.low).z});
    };
    Element element{{at(0, 0), at(1, 0), at(1, 1), at(0, 1)}};
    if (isTurned) std::swap(element.corners[1], element.corners[3]);
    mesh_.elements.push_back(element);
    mesh_.face.push_back(face);
  }
  void addSolid(std::vector<int> faces, std::vector<int> inward = {}) {
    mesh_.groups.push_back({"", GroupKind::Solid, std::move(faces), std::move(inward)});
  }
  const ModelMesh& mesh() const { return mesh_; }

 private:
  VertexId vertex(const Point3& p) {
    const auto [found, isNew] = known_.try_emplace(
        {p.x, p.y, p.z}, VertexId{static_cast<std::uint32_t>(mesh_.vertices.size())});
    if (isNew) mesh_.vertices.push_back(p);
    return found->second;
  }

  ModelMesh mesh_;
  std::map<std::array<double, 3>, VertexId> known_;
};

std::vector<int> facesFrom(int first) {
  return {first, first + 1, first + 2, first + 3, first + 4, first + 5};
}

/// The only volume of this solid (0: void).
const MeshVolume& only(const std::vector<MeshVolume>& volumes, int solid) {
  const MeshVolume* found = nullptr;
  for (const MeshVolume& volume : volumes)
    if (volume.solid == solid) {
      EXPECT_FALSE(found) << "two volumes of " << solid;
      found = &volume;
    }
  static const MeshVolume none{};
  EXPECT_TRUE(found) << "no volume of " << solid;
  return found ? *found : none;
}

constexpr Block kOuter{{0, 0, 0}, {10, 10, 10}}, kInner{{2, 3, 2}, {7, 8, 9}};

TEST(MeshVolumes, OfABlockAreItself) {
  BlockMesh blocks;
  blocks.add(kOuter, 1);
  blocks.addSolid(facesFrom(1));
  const std::vector<MeshVolume> volumes = volumesOf(blocks.mesh());
  ASSERT_EQ(volumes.size(), 1u);
  EXPECT_EQ(volumes[0].solid, 1);
  EXPECT_EQ(volumes[0].faces, facesFrom(1));
  EXPECT_TRUE(isStrictlyIn(kOuter, volumes[0].inside));
}

TEST(MeshVolumes, NothingHasNone) { EXPECT_TRUE(volumesOf({}).empty()); }

TEST(MeshVolumes, ACavityIsAVoid) {
  for (const bool hasSolid : {true, false}) {  // without: as surfaces of triangles are
    BlockMesh blocks;
    blocks.add(kOuter, 1);
    blocks.add(kInner, 7, Looks::Inwards);
    if (hasSolid) blocks.addSolid({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    const std::vector<MeshVolume> volumes = volumesOf(blocks.mesh());
    ASSERT_EQ(volumes.size(), 2u);
    EXPECT_TRUE(isStrictlyIn(kOuter, only(volumes, 1).inside));
    EXPECT_FALSE(isStrictlyIn(kInner, only(volumes, 1).inside));
    EXPECT_TRUE(isStrictlyIn(kInner, only(volumes, 0).inside));
    EXPECT_EQ(only(volumes, 1).faces.size(), 12u);
    EXPECT_EQ(only(volumes, 0).faces, facesFrom(7));
  }
}

TEST(MeshVolumes, ACavityWhoseFacesLookTheWrongWayIsAVoidOfASolid) {
  BlockMesh blocks;
  blocks.add(kOuter, 1);
  blocks.add(kInner, 7);
  blocks.addSolid({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  const std::vector<MeshVolume> volumes = volumesOf(blocks.mesh());
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_FALSE(isStrictlyIn(kInner, only(volumes, 1).inside));
  EXPECT_TRUE(isStrictlyIn(kInner, only(volumes, 0).inside));
}

TEST(MeshVolumes, ThinWallsHaveAPointInThem) {
  constexpr Block kCavity{{1e-7, 1e-7, 1e-7}, {10 - 1e-7, 10 - 1e-7, 10 - 1e-7}};
  BlockMesh blocks;
  blocks.add(kOuter, 1);
  blocks.add(kCavity, 7, Looks::Inwards);
  blocks.addSolid({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  const std::vector<MeshVolume> volumes = volumesOf(blocks.mesh());
  EXPECT_TRUE(isStrictlyIn(kOuter, only(volumes, 1).inside));
  EXPECT_FALSE(isStrictlyIn(kCavity, only(volumes, 1).inside));
  EXPECT_TRUE(isStrictlyIn(kCavity, only(volumes, 0).inside));
}

TEST(MeshVolumes, ASolidInACavityIsNoVoidAndTheGapIsOne) {
  constexpr Block kCore{{3, 4, 3}, {6, 7, 8}};
  BlockMesh blocks;
  blocks.add(kOuter, 1);
  blocks.add(kInner, 7, Looks::Inwards);
  blocks.add(kCore, 13);
  blocks.addSolid({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  blocks.addSolid(facesFrom(13));
  const std::vector<MeshVolume> volumes = volumesOf(blocks.mesh());
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_FALSE(isStrictlyIn(kInner, only(volumes, 1).inside));
  EXPECT_TRUE(isStrictlyIn(kCore, only(volumes, 2).inside));
  EXPECT_TRUE(isStrictlyIn(kInner, only(volumes, 0).inside));
  EXPECT_FALSE(isStrictlyIn(kCore, only(volumes, 0).inside));
}

/// As after --imprint: the core fills the cavity and shares its faces.
TEST(MeshVolumes, ASolidThatFillsACavityLeavesNoVoid) {
  BlockMesh blocks;
  blocks.add(kOuter, 1);
  blocks.add(kInner, 7, Looks::Inwards);
  blocks.addSolid({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  blocks.addSolid(facesFrom(7), facesFrom(7));
  const std::vector<MeshVolume> volumes = volumesOf(blocks.mesh());
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_FALSE(isStrictlyIn(kInner, only(volumes, 1).inside));
  EXPECT_TRUE(isStrictlyIn(kInner, only(volumes, 2).inside));
}

TEST(MeshVolumes, TouchingSolidsBothHaveTheirInterface) {
  constexpr Block kRight{{10, 0, 0}, {15, 10, 10}};
  BlockMesh blocks;
  blocks.add(kOuter, 1);  // face 2 looks to +x
  for (int face = 7, axis = 0; axis < 3; ++axis)
    for (const int end : {0, 1})
      if (axis > 0 || end > 0) blocks.addSide(kRight, axis, end, face++, end == 0);
  blocks.addSolid(facesFrom(1));
  blocks.addSolid({2, 7, 8, 9, 10, 11}, {2});
  const std::vector<MeshVolume> volumes = volumesOf(blocks.mesh());
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_TRUE(isStrictlyIn(kOuter, only(volumes, 1).inside));
  EXPECT_TRUE(isStrictlyIn(kRight, only(volumes, 2).inside));
  EXPECT_EQ(only(volumes, 1).faces, facesFrom(1));
  EXPECT_EQ(only(volumes, 2).faces, (std::vector<int>{2, 7, 8, 9, 10, 11}));
}

TEST(MeshVolumes, ASolidInsideAnotherOneIsItself) {
  BlockMesh blocks;
  blocks.add(kOuter, 1);
  blocks.add(kInner, 7);
  blocks.addSolid(facesFrom(1));
  blocks.addSolid(facesFrom(7));
  const std::vector<MeshVolume> volumes = volumesOf(blocks.mesh());
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_FALSE(isStrictlyIn(kInner, only(volumes, 1).inside));
  EXPECT_TRUE(isStrictlyIn(kInner, only(volumes, 2).inside));
}

TEST(MeshVolumes, SeparateSurfacesAreNumberedEach) {
  BlockMesh blocks;
  blocks.add({{0, 0, 0}, {1, 1, 1}}, 1);
  blocks.add({{2, 0, 0}, {3, 1, 1}}, 7);
  EXPECT_EQ(volumesOf(blocks.mesh()).size(), 2u);
  EXPECT_EQ(only(volumesOf(blocks.mesh()), 2).faces, facesFrom(7));
}

TEST(MeshVolumes, ASurfaceInsideOutStillHasMaterial) {
  BlockMesh blocks;
  blocks.add(kOuter, 1, Looks::Inwards);
  EXPECT_TRUE(isStrictlyIn(kOuter, only(volumesOf(blocks.mesh()), 1).inside));
}

TEST(MeshVolumes, AnOpenSolidHasNone) {
  BlockMesh blocks;
  for (int axis = 0; axis < 3; ++axis) blocks.addSide(kOuter, axis, 0, 1 + axis, true);
  blocks.addSolid({1, 2, 3, 4});
  EXPECT_TRUE(volumesOf(blocks.mesh()).empty());
}

TEST(MeshVolumes, APlateInsideDividesOnlyIfItReachesTheWalls) {
  BlockMesh blocks;
  blocks.add(kOuter, 1);
  blocks.addSide(kInner, 0, 0, 7, false);  // a sheet that floats
  blocks.addSolid(facesFrom(1));
  ASSERT_EQ(volumesOf(blocks.mesh()).size(), 1u);
  EXPECT_EQ(volumesOf(blocks.mesh())[0].faces, facesFrom(1));

  // Two cells of the same solid, divided by a membrane at x = 10.
  BlockMesh divided;
  divided.add(kOuter, 1);
  for (int face = 7, axis = 0; axis < 3; ++axis)
    for (const int end : {0, 1})
      if (axis > 0 || end > 0)
        divided.addSide({{10, 0, 0}, {15, 10, 10}}, axis, end, face++, end == 0);
  divided.addSolid({1, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  const std::vector<MeshVolume> volumes = volumesOf(divided.mesh());
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_EQ(volumes[0].solid, 1);
  EXPECT_EQ(volumes[1].solid, 1);
}

}  // namespace
}  // namespace af2::geometry
