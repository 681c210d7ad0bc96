#include "geometry/occ/faces/most_area.h"

#include <gtest/gtest.h>
#include <BRep_Builder.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>

#include <numbers>

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

}  // namespace
}  // namespace af2::geometry
