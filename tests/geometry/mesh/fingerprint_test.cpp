#include "geometry/mesh/fingerprint.h"

#include <gtest/gtest.h>

#include "tests/support/small_meshes.h"

namespace af2::geometry {
namespace {

TEST(Fingerprint, IsTheSameOnEveryMachine) { EXPECT_EQ(fingerprint({}), "a258d6ec1fb5d95c"); }

TEST(Fingerprint, IsEqualForEqualMeshes) {
  EXPECT_EQ(fingerprint(cubeMesh()), fingerprint(cubeMesh()));
  EXPECT_EQ(fingerprint(cubeMesh()).size(), 16u);
}

TEST(Fingerprint, SeesTheLastBitOfAVertexAndTheOrderOfCorners) {
  ModelMesh moved = cubeMesh();
  moved.vertices[6].x = 0x1.0000000000001p0;
  EXPECT_NE(fingerprint(moved), fingerprint(cubeMesh()));

  ModelMesh turned = cubeMesh();
  std::swap(turned.elements[0].corners[0], turned.elements[0].corners[1]);
  EXPECT_NE(fingerprint(turned), fingerprint(cubeMesh()));
}

}  // namespace
}  // namespace af2::geometry
