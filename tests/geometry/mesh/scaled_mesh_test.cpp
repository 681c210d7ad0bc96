#include "geometry/mesh/scaled_mesh.h"

#include <gtest/gtest.h>

#include "tests/support/model_mesh.h"
#include "tests/support/small_meshes.h"

namespace af2::geometry {
namespace {

TEST(ScaledMesh, HasTheSameElementsAtOtherPlaces) {
  ModelMesh mesh = cubeMesh();
  mesh.wantedSizes.assign(mesh.vertices.size(), 1);
  mesh.faces[0].area = 1;
  mesh.faces[0].stuck.emplace_back().to = {0, 1, 0};
  const ModelMesh scaled = scaledMesh(mesh, 0.5);
  EXPECT_EQ(scaled.elements, mesh.elements);
  EXPECT_EQ(scaled.wantedSizes.back(), 0.5);
  EXPECT_EQ(scaled.faces[0].area, 0.25);
  EXPECT_EQ(scaled.faces[0].stuck[0].to, (Point3{0, 0.5, 0}));
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    EXPECT_EQ(scaled.vertices[v], 0.5 * mesh.vertices[v]);
}

}  // namespace
}  // namespace af2::geometry
