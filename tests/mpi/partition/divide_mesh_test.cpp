#include "geometry/mpi/partition/divide_mesh.h"

#include <gtest/gtest.h>

#include "tests/support/strip.h"

namespace af2::mpi {
namespace {

using geometry::ModelMesh;
using testing::strip;

std::vector<std::int32_t> ownersOf(const ModelMesh& mesh, int parts) {
  const MeshDivision division = divideMesh(mesh, parts);
  std::vector<std::int32_t> owners;
  forEachFaceOf(mesh, [&](const geometry::MeshSlice& slice, const auto& face, std::size_t f) {
    const MeshDivision::FacePatches& patches = division.faces[f];
    for (std::size_t e = face.first; e < face.last; ++e)
      owners.push_back(division.partOfPatch[patches.first + patches.tree.of(middleOf(slice, e))]);
  });
  return owners;
}

TEST(DivideMesh, MakesPartsOfAboutTheSameSizeTheSameEachTime) {
  const ModelMesh mesh = strip(100);
  const std::vector<std::int32_t> owners = ownersOf(mesh, 4);
  EXPECT_EQ(owners, ownersOf(mesh, 4));
  for (int part = 0; part < 4; ++part) {
    EXPECT_GT(std::ranges::count(owners, part), 40);
    EXPECT_LT(std::ranges::count(owners, part), 60);
  }
}

TEST(DivideMesh, LeavesPartsEmptyWhereThereAreMoreThanElements) {
  EXPECT_EQ(ownersOf(strip(1), 5), (std::vector<std::int32_t>{0, 1}));
}

TEST(DivideMesh, KnowsNeighboursInOtherFaces) {
  const std::vector<std::int32_t> owners = ownersOf(strip(120, 3), 4);
  EXPECT_EQ(owners, ownersOf(strip(120), 4)) << "the same elements, on one face";
}

TEST(DivideMesh, PutsManyElementsTogetherWhereThereAreMany) {
  const ModelMesh mesh = strip(20'000);
  const MeshDivision division = divideMesh(mesh, 2);
  EXPECT_LT(division.partOfPatch.size(), 2'100u);
  EXPECT_GT(division.partOfPatch.size(), 900u);
  const std::vector<std::int32_t> owners = ownersOf(mesh, 2);
  EXPECT_NEAR(static_cast<double>(std::ranges::count(owners, 0)), 20'000, 1'000);
}

}  // namespace
}  // namespace af2::mpi
