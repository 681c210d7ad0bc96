#include "geometry/occ/model/named_faces.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "tests/geometry/occ/meshing.h"

namespace af2::geometry {
namespace {

TEST(NamedFaces, AreFacesAndGroups) {
  const Model box = testing::box(1, 1, 1);
  const std::vector<NamedFaces> names{{"inlet", {3}}, {"walls", {4, 1, 2, 4}}};
  const Model named = withNames(box, names);
  EXPECT_EQ(named.faceName(3), "inlet");
  EXPECT_EQ(named.faceName(1), "");
  EXPECT_EQ(box.faceName(3), "");
  ASSERT_EQ(named.groups().size(), box.groups().size() + 1);
  EXPECT_EQ(named.groups().back(), (FaceGroup{"walls", GroupKind::Part, {1, 2, 4}}));

  MeshingOptions options = testing::ofSize(0.5);
  options.sizes.partSizes = {{"inlet", 0.1}};
  const ModelMesh mesh = testing::mesh(named, options);
  EXPECT_EQ(mesh.faces[2].name, "inlet");
  EXPECT_GT(mesh.faces[2].elements, 5 * mesh.faces[0].elements / 2);
}

TEST(NamedFaces, AreRefusedIfThereAreNone) {
  const Model box = testing::box(1, 1, 1);
  const auto name = [&](const NamedFaces& named) { withNames(box, std::vector{named}); };
  EXPECT_THROW(name({"", {1}}), InputError);
  EXPECT_THROW(name({"inlet", {}}), InputError);
  EXPECT_THROW(name({"inlet", {7}}), InputError);
}

}  // namespace
}  // namespace af2::geometry
