#include "geometry/occ/edges/tip_fans.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <gp.hxx>
#include <gp_Circ.hxx>

#include <cmath>
#include <numbers>

#include "geometry/occ/run/mesh_model.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;
constexpr double kHeight = 10;

struct Tip {
  int triangles = 0;
  double shortest = 1e300, longest = 0;  // edges at it
};

Tip tipOf(const ModelMesh& mesh, const Point3& place) {
  Tip tip;
  for (const Element& e : mesh.elements) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](std::size_t k) { return mesh.vertices[e.corners[(i + k) % 3].value]; };
      if (distance(at(0), place) > 1e-9) continue;
      ++tip.triangles;
      for (const std::size_t k : {1, 2}) {
        tip.shortest = std::min(tip.shortest, distance(at(0), at(k)));
        tip.longest = std::max(tip.longest, distance(at(0), at(k)));
      }
    }
  }
  return tip;
}

/// In degrees, if the lateral surface is unrolled.
double angleAround(double radius) { return 360 * radius / std::hypot(radius, kHeight); }

TEST(TipFans, CloseConesHoweverSharp) {
  for (const double radius : {0.15, 0.3, 1.0, 3.0, 5.5}) {
    for (const double size : {0.25, 0.5, 1.0}) {
      SCOPED_TRACE("radius " + std::to_string(radius) + " size " + std::to_string(size));
      const ModelMesh result = testing::mesh(testing::cone(radius, 0, kHeight), size);
      testing::expectComplete(result, pi * radius * (radius + std::hypot(radius, kHeight)), 0.02);
      EXPECT_EQ(testing::eulerNumber(result), 2);
      EXPECT_GT(testing::leastAngle(result), std::min(28.0, 0.9 * angleAround(radius) / 4));
      const Tip tip = tipOf(result, {0, 0, kHeight});
      EXPECT_EQ(tip.triangles, 4);
      EXPECT_NEAR(tip.longest, tip.shortest, 1e-9);
    }
  }
}

TEST(TipFans, HaveThreeQuadrilateralsOnRequestHoweverSharp) {
  for (const double radius : {0.15, 0.3, 1.0, 3.0, 5.5}) {
    MeshingOptions options = testing::ofSize(0.5);
    options.quads.onlyQuads = true;
    const ModelMesh result = testing::mesh(testing::cone(radius, 0, kHeight), options);
    testing::expectComplete(result);
    int quads = 0, triangles = 0;
    for (const Element& e : result.elements)
      for (const VertexId v : e.vertices())
        if (distance(result.vertices[v.value], {0, 0, kHeight}) < 1e-9)
          ++(e.isQuad() ? quads : triangles);
    EXPECT_EQ(quads, 3) << radius;
    EXPECT_EQ(triangles, 0) << radius;
  }
}

TEST(TipFans, LeaveBluntTipsToTheFront) {
  const ModelMesh result = testing::mesh(testing::cone(8, 0, kHeight), 1);
  testing::expectComplete(result);
  EXPECT_TRUE(result.faces[0].attempts.empty());
}

/// Flat sides go from the tip as the edges of the cone do.
TEST(TipFans, ShareATipAmongFaces) {
  for (const double turn : {pi / 2, pi, 1.7 * pi}) {
    for (const double radius : {0.3, 1.0, 3.0}) {
      SCOPED_TRACE("turn " + std::to_string(turn) + " radius " + std::to_string(radius));
      const TopoDS_Shape part = BRepPrimAPI_MakeCone(radius, 0, kHeight, turn).Shape();
      const ModelMesh result = testing::mesh(testing::modelOf(part), 0.5);
      const double lateral = radius * (std::hypot(radius, kHeight) + radius) * turn / 2;
      testing::expectComplete(result, lateral + radius * kHeight, 0.02);
      EXPECT_EQ(testing::eulerNumber(result), 2);
    }
  }
}

TEST(TipFans, StandOnSplinesAndSurfacesOfRevolution) {
  for (const double radius : {0.3, 1.0, 3.0}) {
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(radius, 0, kHeight).Shape();
    const ModelMesh spline =
        testing::mesh(testing::modelOf(BRepBuilderAPI_NurbsConvert(cone).Shape()), 0.5);
    testing::expectComplete(spline, pi * radius * (radius + std::hypot(radius, kHeight)), 0.02);
    EXPECT_EQ(tipOf(spline, {0, 0, kHeight}).triangles, 4);
  }
  // An arc from the axis to the axis: a spindle with two tips.
  const double radius = 26, away = 25;
  const double half = std::acos(away / radius);
  const gp_Circ circle(gp_Ax2({-away, 0, 0}, {0, -1, 0}, {1, 0, 0}), radius);
  const TopoDS_Edge arc = BRepBuilderAPI_MakeEdge(circle, -half, half);
  const ModelMesh spindle =
      testing::mesh(testing::modelOf(BRepPrimAPI_MakeRevol(arc, gp::OZ()).Shape()), 0.5);
  testing::expectComplete(spindle);
  EXPECT_EQ(testing::eulerNumber(spindle), 2);
  for (const double side : {-1.0, 1.0})
    EXPECT_EQ(tipOf(spindle, {0, 0, side * radius * std::sin(half)}).triangles, 4);
}

/// The edge of the cut turns sharply within less than the fan that the size asks for.
TEST(TipFans, AreAsSmallAsACutBesideThemWants) {
  const double radius = 3;
  for (const double away : {0.004, 0.02, 0.3})
    for (const double size : {0.2, 0.5}) {
      SCOPED_TRACE("cut at " + std::to_string(away) + " size " + std::to_string(size));
      const TopoDS_Shape cone = BRepPrimAPI_MakeCone(radius, 0, kHeight).Shape();
      const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-9, -9, -9), gp_Pnt(-away, 9, 19));
      const ModelMesh result =
          testing::mesh(testing::modelOf(BRepAlgoAPI_Cut(cone, block).Shape()), size);
      testing::expectComplete(result);
      EXPECT_EQ(testing::eulerNumber(result), 2);
      EXPECT_GT(testing::leastAngle(result), 20);
      EXPECT_LT(tipOf(result, {0, 0, kHeight}).longest, away * kHeight / radius);
    }
}

/// Where another edge's end stops it, a part may be shorter than the segment at the tip.
TEST(TipFans, LeavePartsThatAreTooShortForThem) {
  EdgePart part;
  part.ends = {3, 4};
  EdgePiece piece;
  for (int i = 0; i <= 10; ++i) {
    piece.parameters.edit().push_back(i * 0.1);
    piece.arcLength.edit().push_back(i * 0.1);
    piece.positions.edit().push_back({i * 0.1, 0, 0});
    piece.sizes.push_back(0.25);
    piece.least.edit().push_back(0);
  }
  part.samples.pieces.push_back(piece);
  part.samples.length = 1;
  CadSizes sizes;
  sizes.size = 0.25;
  EXPECT_EQ(divideFromTips(part, {{3, 2.0}}, {1}, sizes).size(), 5u);
  const std::vector<double> whole = divideFromTips(part, {{3, 0.375}}, {1}, sizes);
  EXPECT_NEAR(whole[1], 0.375, 1e-12);
  EXPECT_EQ(whole.back(), 1);
  EXPECT_NEAR(divideFromTips(part, {{4, 0.375}}, {1}, sizes).end()[-2], 0.625, 1e-12);
}

TEST(TipFans, KeepSegmentsThatAreGiven) {
  const Model model = testing::cone(1, 0, kHeight);
  MeshingOptions options = testing::ofSize(0.5);
  const ModelMesh first = testing::mesh(model, options);
  for (const EdgeSegment& segment : first.segments) {
    auto& points = options.edgePoints[segment.edge];
    points.push_back(first.vertices[segment.to.value]);
  }
  for (auto& [edge, points] : options.edgePoints) points.pop_back();  // the end
  const ModelMesh again = testing::mesh(model, options);
  testing::expectComplete(again);
  EXPECT_EQ(again.segments.size(), first.segments.size());
  EXPECT_EQ(tipOf(again, {0, 0, kHeight}).triangles, 4);
}

TEST(TipFans, HaveMiddlesOnTheSurface) {
  MeshingOptions options = testing::ofSize(0.5);
  options.order = 2;
  const double radius = 1;
  const ModelMesh result = testing::mesh(testing::cone(radius, 0, kHeight), options);
  testing::expectComplete(result);
  for (const Point3& p : result.vertices) {
    if (p.z < 1e-9) continue;  // the base
    EXPECT_NEAR(std::hypot(p.x, p.y), radius * (1 - p.z / kHeight), 1e-6);
  }
}

}  // namespace
}  // namespace af2::geometry
