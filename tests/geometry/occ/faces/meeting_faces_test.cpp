#include "geometry/occ/faces/meeting_faces.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <cmath>

#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/run/dirt.h"

namespace af2::geometry {
namespace {

/// A square in the plane z = height, 4 wide, around the axis.
TopoDS_Face square(double height, double from = -2) {
  return BRepBuilderAPI_MakeFace(gp_Pln({0, 0, height}, {0, 0, 1}), from, 2, -2, 2);
}
/// A tube of radius 1 around the axis.
TopoDS_Face tube(double low, double high) {
  return BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(), 1), 0, 2 * M_PI, low, high);
}

Model both(const TopoDS_Face& one, const TopoDS_Face& other) {
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  builder.Add(all, one);
  builder.Add(all, other);
  return testing::modelOf(all);
}

std::optional<CommonPoint> common(const Model& model, const Point3& nearby) {
  return commonPoint(model.shape(), 1, 2, nearby, 0.05);
}

TEST(CommonPoint, IsFoundWhereFacesPassThroughEachOther) {
  const auto found = common(both(square(0), tube(-1, 1)), {1.2, 0.5, 0.1});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->place.z, 0, 1e-3);
  EXPECT_NEAR(std::hypot(found->place.x, found->place.y), 1, 1e-3);
  EXPECT_FALSE(found->isTouching);
}

TEST(CommonPoint, IsFoundWhereAFaceEndsInsideAnother) {
  EXPECT_TRUE(common(both(square(0), tube(0, 1)), {1.2, 0.5, 0.1}));
}

TEST(CommonPoint, IsFoundWhereFacesLieOnEachOther) {
  const auto found = common(both(square(0), square(0, -1)), {0.5, 0.5, 0});
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->isTouching);
}

TEST(CommonPoint, IsNoneWhereFacesOnlyComeNear) {
  EXPECT_FALSE(common(both(square(0), square(0.1)), {0.5, 0.5, 0.05}));
  EXPECT_FALSE(common(both(square(0), tube(0.1, 1)), {1.2, 0.5, 0.1}));
  EXPECT_FALSE(common(both(square(0, 1.5), tube(-1, 1)), {1.2, 0.5, 0.1}));
}

TEST(CommonPoint, IsNoneAlongACommonEdge) {
  EXPECT_FALSE(common(testing::box(1, 1, 1), {0.01, 0.5, 0.01}));
}

TEST(MeetingFaces, AreToldOfFacesThatFailed) {
  const Model model = both(square(0), tube(-1, 1));
  std::vector<FaceReport> faces(2);
  for (int i = 0; i < 2; ++i) faces[static_cast<std::size_t>(i)].id = i + 1;
  faces[1].status = FaceStatus::Failed;
  faces[1].reason = "elements cross";
  Crossing crossing;
  crossing.faces = {1, 2};
  crossing.place = {1.01, 0.01, 0.01};
  tellOfMeetingFaces(model.shape(), {crossing}, 0.5, faces);
  EXPECT_TRUE(faces[0].reason.empty());
  EXPECT_TRUE(faces[1].reason.starts_with("elements cross; in the model itself it meets face 1"))
      << faces[1].reason;
  EXPECT_EQ(faces[1].cause, FailureCause::Model);
}

/// Four walls in a row, of which the last one passes through the first one.
/// The faces whose elements cross most are looked at first.
TEST(MeetingFaces, AreFoundAmongManyThatOnlyComeNear) {
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  builder.Add(all, square(0));
  std::vector<Crossing> crossings;
  for (int other = 2; other <= 30; ++other) {
    builder.Add(all, square(0.001 * other));
    crossings.push_back({{}, {1, other}, false, {0.5, 0.5, 0}, {}});
  }
  builder.Add(all, tube(-1, 1));
  const Model model = testing::modelOf(all);
  EXPECT_EQ(meetingOf(model.shape(), 1, crossings, 0.5), "");
  for (int i = 0; i < 2; ++i) crossings.push_back({{}, {1, 31}, false, {1, 0.1, 0}, {}});
  EXPECT_NE(meetingOf(model.shape(), 1, crossings, 0.5).find("meets face 31"), std::string::npos);
}

TEST(MeetingFaces, AreMeshedAgainOnceNotTenTimes) {
  BRepBuilderAPI_MakePolygon row;
  for (const gp_Pnt& p :
       {gp_Pnt(0, 0, 0), gp_Pnt(4, 0, 0), gp_Pnt(4, 2, 0), gp_Pnt(2, 2, 0), gp_Pnt(2, -2, 0)})
    row.Add(p);
  int runs = 0;
  MeshingOptions options = testing::ofSize(0.5);
  options.observer = [&](int) {
    ++runs;
    return nullptr;
  };
  const ModelMesh mesh = testing::mesh(
      testing::modelOf(BRepPrimAPI_MakePrism(row.Wire(), gp_Vec(0, 0, 2)).Shape()), options);
  EXPECT_EQ(std::ranges::count(mesh.faces, FaceStatus::Failed, &FaceReport::status), 1);
  EXPECT_LE(runs, 12);
}

TEST(MeetingFaces, AreToldOfANarrowAngleAtACommonEdge) {
  BRepBuilderAPI_MakePolygon outline;
  for (const gp_Pnt& p : {gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0), gp_Pnt(10, 6, 0), gp_Pnt(0, 6, 0),
                          gp_Pnt(0, 3.005, 0), gp_Pnt(5, 3, 0), gp_Pnt(0, 2.995, 0)})
    outline.Add(p);
  outline.Close();
  const Model model = testing::modelOf(
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 2))
          .Shape());
  std::vector<FaceReport> faces(static_cast<std::size_t>(model.faceCount()));
  for (std::size_t i = 0; i < faces.size(); ++i) {
    faces[i].id = static_cast<int>(i) + 1;
    faces[i].status = FaceStatus::Failed;
    faces[i].reason = "stuck";
  }
  tellOfMeetingFaces(model.shape(), {}, 0.5, faces);
  const auto told = std::ranges::count_if(faces, [](const FaceReport& face) {
    return face.reason.starts_with(
        "stuck; in the model itself it encloses an angle of 0.11 degrees");
  });
  EXPECT_EQ(told, 2);  // both sides of the slit
  EXPECT_EQ(std::ranges::count(faces, "stuck", &FaceReport::reason),
            static_cast<std::ptrdiff_t>(faces.size()) - 2);
}

}  // namespace
}  // namespace af2::geometry
