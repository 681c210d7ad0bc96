// Faces on which curvature is noise to elements of the wanted size.
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/occ/sizes/sizing.h"
#include "geometry/occ/surfaces/face_surface.h"
#include "tests/geometry/occ/curves.h"
#include "tests/geometry/occ/meshing.h"

namespace af2::geometry {
namespace {

constexpr double kSize = 1.5;

/// A square of side 25 with poles 0.25 apart, a tenth of which are lifted.
Model noisyGround(double height) {
  constexpr int kPoles = 101;
  TColgp_Array2OfPnt poles(1, kPoles, 1, kPoles);
  std::uint32_t noise = 1;
  for (int i = 1; i <= kPoles; ++i)
    for (int k = 1; k <= kPoles; ++k) {
      noise = 1664525u * noise + 1013904223u;
      poles(i, k) = gp_Pnt(0.25 * (i - 1), 0.25 * (k - 1), (noise >> 16) % 10 == 0 ? height : 0);
    }
  TColStd_Array1OfReal knots(1, kPoles - 2);
  TColStd_Array1OfInteger multiplicities(1, kPoles - 2);
  for (int i = 1; i <= kPoles - 2; ++i) {
    knots(i) = i;
    multiplicities(i) = i == 1 || i == kPoles - 2 ? 4 : 1;
  }
  return testing::modelOf(BRepBuilderAPI_MakeFace(
      new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 3, 3), 1e-6));
}

CadSizes spread(const Model& model) {
  CadSizes sizes;
  sizes.size = kSize;
  return spreadSizes(model.shape(), sizes, unevenFaces(model.shape(), sizes, 1, {}), 1, {});
}

double smallestSize(const Model& model, const CadSizes& sizes) {
  const FaceSurface surface = model.shape().surface(1);
  double smallest = kSize;
  for (double u = 2; u < 98; u += 1.37)
    for (double v = 2; v < 98; v += 1.37)
      smallest = std::min(smallest, curvedSizeAt(sizes, 1, kSize, surface, {{}, {}, u, v}).limit);
  return smallest;
}

TEST(RoughFaces, AreNoTubes) {
  const Model ground = noisyGround(0.6);
  const CadSizes sizes = spread(ground);
  EXPECT_EQ(sizes.roughFaces, std::set<int>{1});
  EXPECT_GE(smallestSize(ground, sizes), sizes.faceLeast * kSize);
  CadSizes asTube;
  asTube.size = kSize;
  EXPECT_LT(smallestSize(ground, asTube), sizes.faceLeast * kSize / 5);
}

TEST(RoughFaces, SmoothOnesAreNone) { EXPECT_TRUE(spread(noisyGround(1e-3)).roughFaces.empty()); }

/// A vase, turned about the axis, whose foot has a rim with a radius of about 0.02.
Model vaseWithARim() {
  const auto profile = testing::splineThrough({{0, 0, 0},
                                               {1.77, 0, -0.12},
                                               {0.93, 0, 0.75},
                                               {0.76, 0, 2.56},
                                               {1.8, 0, 4.7},
                                               {0, 0, 5.705}});
  return testing::modelOf(
      BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(profile).Edge(), gp::OZ()).Shape());
}

/// Sizes are known inside a face whose sizes change too fast along one line only.
TEST(RoughFaces, AreNoneAlongOneRim) {
  const Model vase = vaseWithARim();
  for (const double size : {0.25, 0.2, 0.16, 0.12}) {
    SCOPED_TRACE(size);
    const ModelMesh mesh = testing::mesh(vase, size);
    testing::expectComplete(mesh);
    EXPECT_GT(testing::leastAngle(mesh), 25);
  }
}

/// A strip along y, bent across by a right angle one way and the other, or by two the same way.
Model strip(bool turnsBack, double width) {
  constexpr int kSteps = 48;
  constexpr double kTurn = M_PI / kSteps;
  std::vector<gp_Pnt> points{{0, 0, 0}};
  double heading = -M_PI / 4;
  for (int i = 0; i < kSteps; ++i) {
    heading += turnsBack && i >= kSteps / 2 ? -kTurn : kTurn;
    points.push_back(points.back().Translated(gp_Vec(std::cos(heading), 0, std::sin(heading)) *
                                              (width / kSteps)));
  }
  const auto across = testing::splineThrough(points);
  return testing::modelOf(
      BRepBuilderAPI_MakeFace(new Geom_SurfaceOfLinearExtrusion(across, gp::DY()),
                              across->FirstParameter(), across->LastParameter(), 0, 3, 1e-6));
}

double sizeOn(const Model& model) {
  CadSizes sizes;
  sizes.size = kSize;
  const FaceSurface surface = model.shape().surface(1);
  const SplineSurface::Box& box = surface.box();
  double smallest = kSize;
  for (int i = 1; i < 40; ++i) {
    const SurfacePoint at{{}, {}, box.u1 + i / 40.0 * (box.u2 - box.u1), 1};
    smallest = std::min(smallest, curvedSizeAt(sizes, 1, kSize, surface, at).limit);
  }
  return smallest;
}

TEST(RippledStrips, AreNoTubes) {
  EXPECT_GE(sizeOn(strip(true, 0.05)), TurnLimits().faceLeast * kSize);
  EXPECT_LT(sizeOn(strip(false, 0.05)), 0.1 * kSize);
  EXPECT_LT(sizeOn(strip(true, 0.2)), 0.1 * kSize);  // that wide, the ripple can be seen
}

TEST(RippledStrips, NeedFewElements) {
  const ModelMesh mesh = testing::mesh(strip(true, 0.05), kSize);
  EXPECT_EQ(mesh.faces.at(0).status, FaceStatus::Complete) << mesh.faces[0].reason;
  EXPECT_LT(mesh.elements.size(), 200u);
}

/// Both sides of a thin wing and its sharp edges in one face.
Model thinWing() {
  const std::pair<double, double> section[] = {{1, 0},  {0.4, 0.08}, {-0.5, 0.08},
                                               {-1, 0}, {0, -0.04},  {1, 0}};
  constexpr int kCorners = 6;
  TColgp_Array2OfPnt poles(1, kCorners, 1, 2);
  TColStd_Array1OfReal along(1, kCorners), across(1, 2);
  TColStd_Array1OfInteger times(1, kCorners), twice(1, 2);
  for (int i = 1; i <= kCorners; ++i) {
    const auto [x, z] = section[i - 1];
    poles(i, 1) = gp_Pnt(2 * x, 0, 2 * z);
    poles(i, 2) = gp_Pnt(x + 1, 5, z);
    along(i) = i;
    times(i) = i == 1 || i == kCorners ? 2 : 1;
  }
  for (int i = 1; i <= 2; ++i) across(i) = i, twice(i) = 2;
  return testing::modelOf(BRepBuilderAPI_MakeFace(
      new Geom_BSplineSurface(poles, along, across, times, twice, 1, 1), 1e-6));
}

TEST(RoughFaces, OfAThinWingAreMeshedWithSizesAboveItsLength) {
  const Model model = thinWing();
  for (const double size : {6.0, 3.0, 1.5, 0.4})
    testing::expectComplete(testing::mesh(model, size), 30.1);
  EXPECT_EQ(testing::mesh(model, 3.0).notes,
            std::vector<std::string>{
                "could not be meshed with the size that was asked for: face 1 has 1.5"});
}

}  // namespace
}  // namespace af2::geometry
