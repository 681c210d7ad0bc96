#include "geometry/planar/mesh_planar.h"

#include "engine/base/error.h"
#include "geometry/check/model_check.h"
#include "geometry/domain/domain_model.h"
#include "tests/geometry/planar/poly_text.h"
#include "tests/support/model_mesh.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

const std::string kSquareWithHole =
    "8 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 1\n6 3 1\n7 3 3\n8 1 3\n"
    "8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n1\n1 2 2\n";

class PlanarMeshing : public ::testing::Test {
 protected:
  AF2Algorithm algorithm{testing::triangleSet()};
  MeshingOptions options;

  ModelMesh mesh(const std::string& text) {
    return meshPlanar(testing::polyOf(text), algorithm, options);
  }

  static double areaOf(const ModelMesh& mesh) {
    double area = 0;
    for (const Element& e : mesh.elements) {
      const Point3& a = mesh.vertices[e.corners[0].value];
      area +=
          cross(mesh.vertices[e.corners[1].value] - a, mesh.vertices[e.corners[2].value] - a).z / 2;
    }
    return area;
  }
};

TEST_F(PlanarMeshing, FillsASquareAroundItsHole) {
  options.sizes.size = 0.5;
  const ModelMesh result = mesh(kSquareWithHole);
  EXPECT_TRUE(checkModelMesh(result).empty());
  EXPECT_NEAR(areaOf(result), 12, 1e-12);
  ASSERT_EQ(result.faces.size(), 1u);
  EXPECT_EQ(result.faces[0].status, FaceStatus::Complete);
  EXPECT_EQ(result.faces[0].area, 12);
  EXPECT_EQ(result.segments.size(), 48u);
}

TEST_F(PlanarMeshing, RefusesSizesThatAskForTooManyElements) {
  options.sizes.size = 1e-5;
  EXPECT_THROW(mesh(kSquareWithHole), InputError);
}

TEST_F(PlanarMeshing, RefusesOptionsThatMakeNoSense) {
  const auto isRefused = [&](auto&& change) {
    options = {};
    options.sizes.size = 0.5;
    change(options);
    EXPECT_THROW(mesh(kSquareWithHole), InputError);
  };
  const double none = std::numeric_limits<double>::quiet_NaN();
  isRefused([](auto& o) { o.sizes.minSize = 0.5, o.sizes.maxSize = 0.1; });
  isRefused([&](auto& o) { o.sizes.minSize = none; });
  isRefused([](auto& o) { o.sizes.growth = -1; });
  isRefused([&](auto& o) { o.sizes.growth = none; });
  isRefused([](auto& o) { o.sizes.elementsPerTurn = 1; });
  isRefused([&](auto& o) { o.sizes.elementsAcross = none; });
  isRefused([&](auto& o) { o.sizes.partSizes = {{"*", none}}; });
}

TEST_F(PlanarMeshing, RefusesDomainsOfAProgramThatNameWhatIsNotThere) {
  options.sizes.size = 0.5;
  const auto isRefused = [&](auto&& change) {
    PlanarDomain domain = testing::polyOf(kSquareWithHole);
    change(domain);
    EXPECT_THROW(meshPlanar(domain, algorithm, options), InputError);
  };
  isRefused([](PlanarDomain& d) { d.points[2].x = std::numeric_limits<double>::infinity(); });
  isRefused([](PlanarDomain& d) { d.segments[2].to = 99; });
  isRefused([](PlanarDomain& d) { d.segments[2].from = -1; });
  isRefused([](PlanarDomain& d) { d.holes[0].y = std::numeric_limits<double>::quiet_NaN(); });
}

TEST_F(PlanarMeshing, RefusesModelsWithPartsThatAreNotThere) {
  options.sizes.size = 0.5;
  const auto faultOf = [&](auto&& change) {
    DomainModel model = planarModel(testing::polyOf(kSquareWithHole), options);
    change(model);
    return testing::messageOf([&] { meshDomain(model, algorithm, options); });
  };
  EXPECT_EQ(faultOf([](DomainModel& m) { m.faces[0].surface = nullptr; }),
            "face 1 of the model has no surface");
  EXPECT_EQ(faultOf([](DomainModel& m) { m.faces[0].loops[1][0].curve = 99; }),
            "face 1 of the model is bounded by a curve that does not exist");
  EXPECT_EQ(faultOf([](DomainModel& m) { m.faces[0].loops.clear(); }),
            "face 1 of the model has no boundary; cut a closed surface along curves");
  EXPECT_EQ(faultOf([](DomainModel& m) { m.curves[2].last = 99; }),
            "curve 3 of the model has an end that is not a corner of it");
  EXPECT_EQ(faultOf([](DomainModel& m) {
              m.curves[2].knots = {1, 0};
            }),
            "curve 3 of the model needs knots at its ends, in ascending order");
}

TEST_F(PlanarMeshing, KnowsWhichSegmentsAreMarkedAsBoundaries) {
  options.sizes.size = 0.5;
  // The hole is unmarked, the last segment lies on half of the one marked 7.
  const ModelMesh result = mesh(
      "9 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 1\n6 3 1\n7 3 3\n8 1 3\n9 2 0\n"
      "9 1\n1 1 2 7\n2 2 3 -3\n3 3 4 7\n4 4 1 0\n5 5 6 0\n6 6 7 0\n7 7 8 0\n8 8 5 0\n"
      "9 1 9 4\n1\n1 2 2\n");
  EXPECT_TRUE(checkModelMesh(result).empty());
  const std::vector<EdgeGroup> expected{{-3, "", {2}}, {7, "", {1, 3}}};
  EXPECT_EQ(result.boundaries, expected);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_NE(result.notes[0].find("line 20: this segment coincides with that of line 12"),
            std::string::npos)
      << result.notes[0];
}

TEST_F(PlanarMeshing, TakesTheMarkerOfWhicheverOfTwoEqualSegmentsHasOne) {
  options.sizes.size = 1;
  const ModelMesh result =
      mesh("3 2 0 0\n1 0 0\n2 4 0\n3 0 4\n4 1\n1 1 2 0\n2 2 3 0\n3 3 1 0\n4 2 1 9\n0\n");
  EXPECT_TRUE(checkModelMesh(result).empty());
  EXPECT_EQ(result.boundaries, (std::vector<EdgeGroup>{{9, "", {4}}}));
  EXPECT_TRUE(result.notes.empty());
}

TEST_F(PlanarMeshing, SharesVerticesBetweenRegions) {
  options.sizes.size = 0.5;
  const std::string withoutHole = kSquareWithHole.substr(0, kSquareWithHole.size() - 8) + "0\n";
  const ModelMesh result = mesh(withoutHole);
  EXPECT_TRUE(checkModelMesh(result).empty());
  EXPECT_EQ(result.faces.size(), 2u);
  EXPECT_NEAR(areaOf(result), 16, 1e-12);
}

TEST_F(PlanarMeshing, MakesGroupsOfRegionsWithTheSameAttribute) {
  options.sizes.size = 0.5;
  const std::string halves =
      "6 2 0 0\n1 0 0\n2 2 0\n3 4 0\n4 4 2\n5 2 2\n6 0 2\n"
      "7 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 6\n6 6 1\n7 2 5\n0\n";
  const ModelMesh apart = mesh(halves + "2\n1 1 1 7.5 0.01\n2 3 1 8\n");
  ASSERT_EQ(apart.groups.size(), 2u);
  EXPECT_EQ(apart.groups[0], (FaceGroup{"region 7.5", GroupKind::Part, {1}}));
  EXPECT_EQ(apart.groups[1], (FaceGroup{"region 8", GroupKind::Part, {2}}));
  EXPECT_GT(apart.faces[0].elements, 4 / 0.01 * 0.8) << "the largest area that its region allows";
  EXPECT_LT(apart.faces[1].elements, apart.faces[0].elements / 3);
  const ModelMesh joined = mesh(halves + "2\n1 1 1 7\n2 3 1 7\n");
  EXPECT_EQ(joined.groups, (std::vector{FaceGroup{"region 7", GroupKind::Part, {1, 2}}}));
}

TEST_F(PlanarMeshing, KeepsASegmentThatEndsInside) {
  options.sizes.size = 0.5;
  const ModelMesh result = mesh(
      "5 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 2 2\n5 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 1 5\n0\n");
  EXPECT_TRUE(checkModelMesh(result).empty());
  int inside = 0;
  for (const EdgeSegment& segment : result.segments) {
    if (segment.edge != 5) continue;
    ++inside;
    EXPECT_EQ(segment.uses, 2);
  }
  EXPECT_EQ(inside, 6);
}

TEST_F(PlanarMeshing, KeepsTheBoundaryThatIsGiven) {
  options.sizes.size = 0.5;
  options.keepBoundary = true;
  const ModelMesh result = mesh(kSquareWithHole);
  EXPECT_TRUE(checkModelMesh(result).empty());
  EXPECT_EQ(result.faces[0].status, FaceStatus::Complete);
  EXPECT_EQ(result.segments.size(), 8u);
}

TEST_F(PlanarMeshing, FollowsPointsBoxesAndBounds) {
  options.sizes.size = 1;
  options.sizes.sources.points = {{{0, 0, 0}, 0.1}};
  options.sizes.minSize = 0.3;
  const ModelMesh result = mesh(kSquareWithHole);
  EXPECT_TRUE(checkModelMesh(result).empty());
  ASSERT_EQ(result.wantedSizes.size(), result.vertices.size());
  EXPECT_EQ(result.wantedSizes[0], 0.3);
  EXPECT_GT(result.elements.size(), 30u);
}

TEST_F(PlanarMeshing, FollowsASizeFunction) {
  options.sizes.size = 1;
  options.sizes.function = [](const Point3& p) { return 0.1 + 0.2 * p.x; };
  const ModelMesh result =
      mesh("4 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  EXPECT_TRUE(checkModelMesh(result).empty());
  int left = 0, right = 0;
  for (const EdgeSegment& segment : result.segments) {
    if (segment.edge == 4) ++left;
    if (segment.edge == 2) ++right;
  }
  EXPECT_EQ(left, 40);
  EXPECT_NEAR(right, 4.0 / 0.9, 1);
}

TEST_F(PlanarMeshing, GivesTheSameBytesEachTime) {
  options.sizes.size = 0.3;
  const ModelMesh first = mesh(kSquareWithHole), second = mesh(kSquareWithHole);
  EXPECT_EQ(first.vertices, second.vertices);
  EXPECT_EQ(first.elements, second.elements);
}

TEST_F(PlanarMeshing, RefusesASizeThatIsNotPositive) {
  options.sizes.size = 0;
  EXPECT_THROW(mesh(kSquareWithHole), InputError);
  options.sizes.size = 1;
  options.sizes.function = [](const Point3&) { return -1.0; };
  EXPECT_THROW(mesh(kSquareWithHole), InputError);
}

TEST_F(PlanarMeshing, HasTheVerticesThatNoSegmentUses) {
  options.sizes.size = 0.5;
  // In the square, in its hole, outside, and on a segment.
  const std::string loose = "12" +
                            kSquareWithHole.substr(1, kSquareWithHole.find("8 0\n1 1 2") - 1) +
                            "9 0.31 2.17\n10 2 2\n11 9 9\n12 1.05 0\n" +
                            kSquareWithHole.substr(kSquareWithHole.find("8 0\n1 1 2"));
  const ModelMesh result = mesh(loose);
  testing::expectComplete(result);
  EXPECT_NEAR(areaOf(result), 12, 1e-12);
  const auto has = [&](const Point3& p) { return std::ranges::count(result.vertices, p) == 1; };
  EXPECT_TRUE(has({0.31, 2.17, 0}));
  EXPECT_TRUE(has({1.05, 0, 0}));
  EXPECT_FALSE(has({2, 2, 0}));
  EXPECT_FALSE(has({9, 9, 0}));
}

TEST_F(PlanarMeshing, MakesRoomForVerticesThatAreClose) {
  options.sizes.size = 1;
  std::string text = "68 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n";
  for (int i = 0; i < 64; ++i)  // about an eighth apart, where one element would do
    text += std::to_string(i + 5) + " " + std::to_string(0.06 + 0.12 * (i % 8) + 0.003 * (i / 8)) +
            " " + std::to_string(0.06 + 0.12 * (i / 8)) + "\n";
  const ModelMesh result = mesh(text + "4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  testing::expectComplete(result);
  EXPECT_NEAR(areaOf(result), 1, 1e-12);
  EXPECT_GE(result.vertices.size(), 68u);
  EXPECT_GT(testing::leastAngle(result), 15);
}

TEST_F(PlanarMeshing, TakesWhatCannotBeSeenForOne) {
  options.sizes.size = 0.5;
  // A segment of 1e-30, and a corner of the hole that all but lies on the outer square.
  const std::string text =
      "8 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 1e-30 4\n5 0 4\n6 1 1\n7 2 1e-9\n8 3 1\n"
      "8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 1\n6 6 7\n7 7 8\n8 8 6\n1\n1 2 0.6\n";
  const ModelMesh result = mesh(text);
  testing::expectComplete(result);
  ASSERT_EQ(result.faces.size(), 1u);
  EXPECT_NEAR(areaOf(result), 15, 1e-6);
  ASSERT_FALSE(result.faces[0].attempts.empty());
  EXPECT_NE(result.faces[0].attempts[0].find("at 2 places"), std::string::npos)
      << result.faces[0].attempts[0];
}

TEST_F(PlanarMeshing, DividesASegmentAsAsked) {
  options.sizes.size = 1;
  options.sizes.edgeSizes[2] = 0.1;
  options.edgePoints[4] = {{0, 3, 0}, {0, 0.5, 0}};
  const ModelMesh result = mesh(kSquareWithHole);
  testing::expectComplete(result);
  EXPECT_EQ(std::ranges::count(result.segments, 2, &EdgeSegment::edge), 40);
  EXPECT_EQ(std::ranges::count(result.segments, 4, &EdgeSegment::edge), 3);
  EXPECT_EQ(std::ranges::count(result.vertices, Point3{0, 0.5, 0}), 1);
  options.edgePoints[4] = {{0.1, 3, 0}};
  EXPECT_THROW(mesh(kSquareWithHole), InputError);
}

TEST_F(PlanarMeshing, OpensThinAnglesByShorterEdges) {
  // A hole so near to the border that edges of the wanted length leave no angle beside it.
  options.sizes.size = 1;
  const ModelMesh result = mesh(
      "8 2 0 0\n1 0 0\n2 8 0\n3 8 8\n4 0 8\n5 3 0.01\n6 5 0.01\n7 5 3\n8 3 3\n"
      "8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n1\n1 4 2\n");
  testing::expectComplete(result);
  EXPECT_GT(testing::leastAngle(result), 1.5) << "and 0.6 at the first try";
  EXPECT_FALSE(result.faces[0].attempts.empty()) << "each step is named";
}

TEST_F(PlanarMeshing, StopsWhenAsked) {
  options.sizes.size = 0.01;
  std::stop_source source;
  source.request_stop();
  options.stop = source.get_token();
  const ModelMesh result = mesh(kSquareWithHole);
  EXPECT_EQ(result.faces[0].status, FaceStatus::Cancelled);
  EXPECT_TRUE(result.elements.empty());
}

}  // namespace
}  // namespace af2::geometry
