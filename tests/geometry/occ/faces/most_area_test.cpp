#include "geometry/occ/faces/most_area.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <numbers>
#include <utility>

namespace af2::geometry {
namespace {

using std::numbers::pi;

TopoDS_Face faceOn(const Handle(Geom_Surface) & surface) {
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, surface, 1e-7);
  return face;
}

/// Half around a surface of radius 1 and a little up, then straight back.
FrontInput halfAround(const FaceSurface& surface, double height) {
  FrontInput input;
  auto& loop = input.loops.emplace_back();
  constexpr int kSteps = 16;
  for (int i = 0; i <= kSteps; ++i) loop.push_back({{}, surface.at(pi * i / kSteps, 0)});
  loop.push_back({{}, surface.at(pi, height)});
  loop.push_back({{}, surface.at(0, height)});
  return input;
}

TEST(MostArea, LiesWithinTheBoundaryWhereASurfaceDoesNotEnd) {
  const Handle(Geom_Surface) tube = new Geom_CylindricalSurface(gp_Ax3(), 1);
  const Handle(Geom_Surface) part = new Geom_RectangularTrimmedSurface(tube, 0, 2 * pi, 0, 1e6);
  for (const Handle(Geom_Surface) & surface : {tube, part}) {
    const TopoDS_Face face = faceOn(surface);
    const FaceSurface charted(face);
    EXPECT_NEAR(mostArea(face, charted, halfAround(charted, 0.1)), 0.1 * pi, 1e-9);
  }
}

TEST(MostArea, IsThatOfTheWholeSurfaceWhereItEnds) {
  const TopoDS_Face face = faceOn(new Geom_SphericalSurface(gp_Ax3(), 1));
  const FaceSurface charted(face);
  EXPECT_GE(mostArea(face, charted, halfAround(charted, 0.1)), 4 * pi * (1 - 1e-3));
}

/// Where it is far narrower than long.
TEST(MostArea, IsNoMoreThanThatOfTheSurface) {
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  for (int i = 1; i <= 2; ++i)
    for (int k = 1; k <= 2; ++k) poles(i, k) = gp_Pnt(4 * i, 0.01 * k, 0.002 * i * k);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7);
  const FaceSurface charted(face);
  FrontInput input;
  auto& loop = input.loops.emplace_back();
  for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
    loop.push_back({{}, charted.at(u, v)});
  EXPECT_NEAR(mostArea(face, charted, input), 0.04, 0.002);
}

}  // namespace
}  // namespace af2::geometry
