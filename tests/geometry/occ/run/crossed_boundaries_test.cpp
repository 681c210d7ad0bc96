// What is said of faces whose boundary crosses itself or runs back over itself.
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakePolygon.hxx>

#include <string>
#include <vector>

#include "tests/geometry/occ/meshing.h"

namespace af2::geometry {
namespace {

std::string reasonFor(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& corner : corners) polygon.Add(corner);
  polygon.Close();
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), polygon.Wire());
  return testing::mesh(face, 2).faces[0].reason;
}

TEST(CrossedBoundaries, AreNamedWithThePlace) {
  const std::string bow = reasonFor({{0, 0, 0}, {10, 10, 0}, {10, 0, 0}, {0, 10, 0}});
  EXPECT_EQ(bow.find("its boundary crosses itself near ("), 0u) << bow;
}

TEST(CrossedBoundaries, ThatRunBackAreNamedWithThePlace) {
  const std::string back =
      reasonFor({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {4, 10, 0}, {8, 10, 0}, {0, 10, 0}});
  EXPECT_EQ(back.find("its boundary runs back over itself near ("), 0u) << back;
}

}  // namespace
}  // namespace af2::geometry
