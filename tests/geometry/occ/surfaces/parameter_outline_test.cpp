#include "geometry/occ/surfaces/parameter_outline.h"

#include <gtest/gtest.h>
#include <BRepTools.hxx>

#include <set>

#include "tests/geometry/occ/shapes.h"

namespace af2::geometry {
namespace {

using namespace af2::testing;

/// Compares an outline with OpenCASCADE at the places that are not next to the boundary. Returns
/// how many of these are on the face and beside it.
std::pair<int, int> compare(const TopoDS_Face& face) {
  double u1, u2, v1, v2;
  BRepTools::UVBounds(face, u1, u2, v1, v2);
  ParameterOutline outline(face);
  const BRepTopAdaptor_FClass2d exact(face, 1e-7);
  constexpr int kSteps = 30;
  constexpr double kBeside = 0.012;  // of the box; chords are nearer
  int inside = 0, outside = 0;
  for (int i = 0; i < kSteps; ++i)
    for (int k = 0; k < kSteps; ++k) {
      const double s = (i + 0.5) / kSteps, t = (k + 0.5) / kSteps;
      const auto stateAt = [&](double ds, double dt) {
        return exact.Perform({u1 + (s + ds) * (u2 - u1), v1 + (t + dt) * (v2 - v1)}, false);
      };
      std::set<TopAbs_State> states;
      for (const double ds : {-kBeside, 0.0, kBeside})
        for (const double dt : {-kBeside, 0.0, kBeside}) states.insert(stateAt(ds, dt));
      if (states.size() > 1) continue;
      const bool isIn = *states.begin() == TopAbs_IN;
      EXPECT_EQ(outline.has(u1 + s * (u2 - u1), v1 + t * (v2 - v1)), isIn) << s << ", " << t;
      ++(isIn ? inside : outside);
    }
  return {inside, outside};
}

void compareAll(const TopoDS_Shape& shape) {
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    SCOPED_TRACE(BRepAdaptor_Surface(TopoDS::Face(it.Current())).GetType());
    EXPECT_GT(compare(TopoDS::Face(it.Current().Oriented(TopAbs_FORWARD))).first, 100);
  }
}

TEST(ParameterOutline, HasWhatTheFaceHas) {
  compareAll(BRepPrimAPI_MakeCylinder(2, 3).Shape());
  compareAll(BRepPrimAPI_MakeCone(2, 1, 3).Shape());
  compareAll(BRepPrimAPI_MakeSphere(2).Shape());
  compareAll(BRepPrimAPI_MakeTorus(5, 2).Shape());
  compareAll(drilledBlock());
  compareAll(BRepAlgoAPI_Cut(BRepPrimAPI_MakeTorus(5, 2).Shape(),
                             BRepPrimAPI_MakeSphere(gp_Pnt(5, 0, 0), 3).Shape())
                 .Shape());
}

TEST(ParameterOutline, LeavesOutHoles) {
  const auto hole = [](double from, double to) {
    return TopoDS::Wire(rectangle(from, from, to, to).Reversed());
  };
  const auto [inside, outside] =
      compare(plane({rectangle(0, 0, 4, 4), hole(1, 3), hole(0.2, 0.8)}));
  EXPECT_GT(inside, 300);
  EXPECT_GT(outside, 100);
}

TEST(ParameterOutline, AsksOpenCascadeWhereTheBoundaryIsNotClosed) {
  // Without its seam and poles, a sphere has no boundary at all; without a side, a rectangle has
  // none there.
  const TopoDS_Face bare = BRepBuilderAPI_MakeFace(gp_Sphere(gp_Ax3(), 2));
  compare(bare);
  BRepBuilderAPI_MakePolygon three({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, false);
  const TopoDS_Face open =
      BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1})), three.Wire());
  compare(open);
}

}  // namespace
}  // namespace af2::geometry
