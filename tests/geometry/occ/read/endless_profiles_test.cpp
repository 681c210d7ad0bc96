#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <gp_Hypr.hxx>
#include <numbers>

#include "tests/geometry/occ/in_step.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

/// A hyperbola turned about its axis, from where that meets it.
TopoDS_Shape hyperboloid(double angle) {
  const gp_Ax2 axes(gp_Pnt(), gp::DY(), gp::DX());
  const TopoDS_Edge profile = BRepBuilderAPI_MakeEdge(gp_Hypr(axes, 0.5, 0.8), 0, 1);
  return BRepPrimAPI_MakeRevol(profile, gp_Ax1(gp_Pnt(), gp::DX()), angle).Shape();
}

TEST(EndlessProfiles, OfHyperboloidsAreRead) {
  for (const double angle : {2.0, 2 * std::numbers::pi}) {
    const testing::TestFile file("hyperboloid.step", testing::inStep(hyperboloid(angle)));
    const Model model = readModel(file.path());
    EXPECT_TRUE(model.lostFaces().empty());
    const ModelMesh mesh = testing::mesh(model, 0.1);
    ASSERT_EQ(mesh.faces.size(), 1u);
    EXPECT_EQ(mesh.faces[0].status, FaceStatus::Complete) << mesh.faces[0].reason;
    const ModelMesh made = testing::mesh(hyperboloid(angle), 0.1);
    EXPECT_NEAR(mesh.faces[0].area, made.faces[0].area, 1e-6);
  }
}

}  // namespace
}  // namespace af2::geometry
