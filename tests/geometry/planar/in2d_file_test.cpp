#include "geometry/planar/in2d_file.h"

#include <algorithm>
#include <cmath>

#include "geometry/check/model_check.h"
#include "tests/support/test_folder.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

/// A square with a disc of another domain inside, and a square hole in that.
const std::string kDisc =
    "splinecurves2dv2\n2\npoints\n1 -2 -2\n2 2 -2\n3 2 2\n4 -2 2\n"
    "5 1 0\n6 1 1\n7 0 1\n8 -1 1\n9 -1 0\n10 -1 -1\n11 0 -1\n12 1 -1\n"
    "13 -0.2 -0.2\n14 0.2 -0.2\n15 0.2 0.2\n16 -0.2 0.2\n"
    "segments\n1 0 2 1 2 -bc=1\n1 0 2 2 3 -bc=1\n1 0 2 3 4 -bc=1\n1 0 2 4 1 -bc=1\n"
    "2 1 3 5 6 7\n2 1 3 7 8 9\n2 1 3 9 10 11\n2 1 3 11 12 5\n"
    "0 2 2 13 14\n0 2 2 14 15\n0 2 2 15 16\n0 2 2 16 13\n"
    "materials\n1 air\n2 iron -maxh=0.15\n";

PlanarCurves read(const std::string& text) {
  return readIn2d(testing::TestFile("test.in2d", text).path());
}

ModelMesh mesh(const std::string& text, double size) {
  const AF2Algorithm algorithm(testing::triangleSet());
  MeshingOptions options;
  options.sizes.size = size;
  return meshPlanar(domainOf(read(text)), algorithm, options);
}

TEST(In2dFile, HasArcsOfCircles) {
  const PlanarCurves curves = read(kDisc);
  ASSERT_EQ(curves.curves.size(), 12u);
  for (std::size_t c = 4; c < 8; ++c)
    for (const double t : {0.0, 0.1, 0.5, 0.77, 1.0})
      EXPECT_NEAR(length(pointOn(curves, curves.curves[c], t)), 1, 1e-12);
}

TEST(In2dFile, OfTheOldKindNumbersPointsInTheirOrder) {
  const std::string rounded =
      "splinecurves2d\n1\n\n5\n-1 -1 1\n+1 -1 1\n+1 0 1\n+1 +1 1\n0 +1 1\n\n"
      "4\n1 0 2 1 2 1\n1 0 2 2 3 1\n1 0 3 3 4 5 1\n1 0 2 5 1 1\n";
  const PlanarCurves curves = read(rounded);
  ASSERT_EQ(curves.points.size(), 5u);
  ASSERT_EQ(curves.curves.size(), 4u);
  EXPECT_EQ(curves.curves[2].control, 3);
  EXPECT_NEAR(length(pointOn(curves, curves.curves[2], 0.5)), 1, 1e-12);
  const ModelMesh result = mesh(rounded, 0.3);
  EXPECT_TRUE(checkModelMesh(result).empty());
  // Below the chord from (1, 0) to (0, 1), and the segment of the circle beyond it.
  EXPECT_NEAR(result.faces.at(0).area, 2.5 + (3.1416 / 4 - 0.5), 0.02);
  EXPECT_EQ(result.faces.at(0).status, FaceStatus::Complete);
}

TEST(In2dFile, GivesDomainsAsGroupsAndLeavesHolesOut) {
  const ModelMesh result = mesh(kDisc, 0.5);
  EXPECT_TRUE(result.findings.empty());
  EXPECT_TRUE(checkModelMesh(result).empty());
  ASSERT_EQ(result.faces.size(), 2u);
  for (const FaceReport& face : result.faces)
    EXPECT_EQ(face.status, FaceStatus::Complete) << face.reason;
  ASSERT_EQ(result.groups.size(), 2u);
  EXPECT_EQ(result.groups[0].name, "air");
  EXPECT_EQ(result.groups[1].name, "iron");
  const auto face = [&](std::size_t group) {
    return result.faces[static_cast<std::size_t>(result.groups[group].faces.at(0)) - 1];
  };
  EXPECT_NEAR(face(0).area, 16 - 3.1416, 0.05);
  EXPECT_NEAR(face(1).area, 3.1416 - 0.16, 0.05);
  EXPECT_GT(face(1).elements, 200u) << "-maxh of the domain";
  for (std::size_t v = 0; v < result.vertices.size(); ++v)
    EXPECT_EQ(result.wantedSizes[v], length(result.vertices[v]) < 1 + 1e-9 ? 0.15 : 0.5);
}

TEST(In2dFile, HasNoSegmentThatTurnsByMoreThanWasAskedFor) {
  const std::string quarter =
      "splinecurves2dv2\n2\npoints\n1 1 0\n2 1 1\n3 0 1\n4 0 0\n"
      "segments\n1 0 3 1 2 3\n1 0 2 3 4\n1 0 2 4 1\n";
  const AF2Algorithm algorithm(testing::triangleSet());
  for (const double perTurn : {12.0, 13.0, 15.0, 17.0}) {
    MeshingOptions options;
    options.sizes.size = 5;
    options.sizes.elementsPerTurn = perTurn;
    const ModelMesh result = meshPlanar(domainOf(read(quarter)), algorithm, options);
    const auto segments = std::ranges::count(result.segments, 1, &EdgeSegment::edge);
    EXPECT_EQ(segments, static_cast<long>(std::ceil(perTurn / 4))) << perTurn;
  }
}

TEST(In2dFile, GivesBoundariesByNumberAndByName) {
  const std::string square = "splinecurves2dv2\n2\npoints\n1 0 0\n2 1 0\n3 1 1\n4 0 1\nsegments\n";
  const ModelMesh result =
      mesh(square +
               "1 0 2 1 2 -bc=4\n1 0 2 2 3 -bcname=inlet\n1 0 discretepoints 3 1 1 0.5 1 0 1\n"
               " -bc=2 -bcname=wall\n1 0 2 4 1 -bc=wall\n",
           0.2);
  const std::vector<EdgeGroup> expected{{2, "wall", {3, 4}}, {4, "", {1}}, {5, "inlet", {2}}};
  EXPECT_EQ(result.boundaries, expected);
  for (const std::string number : {"2147483647", "-9223372036854775808"})
    EXPECT_THROW(read(square + "1 0 2 1 2 -bc=" + number + "\n"), InputError);
  EXPECT_THROW(read(square + "1 0 2 1 2 -bc=4 -bcname=a\n1 0 2 2 3 -bc=4 -bcname=b\n"), InputError);
}

TEST(In2dFile, HasBSplinesWithEqualKnots) {
  // Of order 3 with three poles it is a parabola; of order 2, straight from pole to pole.
  const PlanarCurves curves = read(
      "splinecurves2dv2\n2\npoints\n1 0 0\n2 4 0\nsegments\n"
      "1 0 2 1 2\n1 0 bsplinepoints 3 3 4 0 2 4\n 0 0 -bc=2\n");
  ASSERT_EQ(curves.curves.size(), 2u);
  const auto at = [&](double t) { return pointOn(curves, curves.curves[1], t); };
  EXPECT_EQ(at(0), (Point2{4, 0}));
  EXPECT_EQ(at(1), (Point2{0, 0}));
  EXPECT_NEAR(distance(at(0.5), {2, 2}), 0, 1e-14);
  EXPECT_NEAR(distance(at(0.25), {3, 1.5}), 0, 1e-14);
  const PlanarCurves longer = read(
      "splinecurves2dv2\n2\npoints\n1 0 0\n2 4 0\nsegments\n"
      "1 0 2 1 2\n1 0 bsplinepoints 5 4 4 0 4 2 2 4 0 2 0 0\n");
  // Knots 0 0 0 0 1 2 2 2 2: halfway the blend of the middle poles is 1/4, 1/2, 1/4.
  EXPECT_NEAR(distance(pointOn(longer, longer.curves[1], 0.5), {2, 3}), 0, 1e-14);
}

TEST(In2dFile, MeshesBSplinesAndPolylines) {
  const ModelMesh parabola = mesh(
      "splinecurves2dv2\n2\npoints\n1 0 0\n2 4 0\nsegments\n"
      "1 0 2 1 2\n1 0 bsplinepoints 3 3 4 0 2 4 0 0\n",
      0.2);
  EXPECT_EQ(parabola.faces.at(0).status, FaceStatus::Complete) << parabola.faces[0].reason;
  EXPECT_NEAR(parabola.faces[0].area, 16.0 / 3, 0.01);
  const ModelMesh polyline = mesh(
      "splinecurves2dv2\n2\npoints\n1 0 0\n2 4 0\nsegments\n"
      "1 0 2 1 2\n1 0 discretepoints 4\n4 0\n4 1\n0 1\n0 0\n",
      0.2);
  EXPECT_EQ(polyline.faces.at(0).status, FaceStatus::Complete) << polyline.faces[0].reason;
  EXPECT_NEAR(polyline.faces[0].area, 4, 1e-9);
}

TEST(In2dFile, TellsMistakesWithTheirLine) {
  const auto faultOf = [](const std::string& text) -> std::string {
    try {
      mesh(text, 0.5);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_NE(faultOf("splinecurves\n").find(":1: only files"), std::string::npos);
  EXPECT_NE(faultOf("splinecurves2dv2\n2\npoints\n1 0 0\nsegments\n1 0 2 1 7\n")
                .find(":6: there is no point 7"),
            std::string::npos);
  EXPECT_NE(faultOf("splinecurves2dv2\n2\nsegments\n1 0 bsplinepoints 2 3 0 0 1 1\n")
                .find(":4: a curve of order 3 has at least as many points"),
            std::string::npos);
  EXPECT_NE(faultOf("splinecurves2dv2\n2\nsegments\n1 0 bsplinepoints 3 3 0 0 1 x 2 2\n")
                .find(":4: 'x' is not a number"),
            std::string::npos);
  std::string wrong = kDisc;
  wrong.replace(wrong.find("1 0 2 3 4"), 9, "3 0 2 3 4");
  EXPECT_NE(faultOf(wrong).find("this segment borders on domain"), std::string::npos);
}

}  // namespace
}  // namespace af2::geometry
