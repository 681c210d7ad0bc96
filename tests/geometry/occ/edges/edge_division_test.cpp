#include "geometry/occ/edges/edge_division.h"

#include <gtest/gtest.h>
#include <BRepAdaptor_Curve.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopoDS.hxx>

#include <numbers>
#include <set>

#include "geometry/occ/sizes/sizing.h"
#include "tests/geometry/occ/meshing.h"

namespace af2::geometry {
namespace {

using testing::uniform;

DividedEdges divide(const Model& model, const CadSizes& sizes) {
  return divideEdges(model.shape(), sampleEdges(model.shape(), sizes, 1, {}), sizes, 1, {});
}

std::vector<double> lengths(const DividedEdges& divided, const DividedEdge& edge) {
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < edge.points.size(); ++i)
    result.push_back(distance(divided.points[edge.points[i]], divided.points[edge.points[i + 1]]));
  return result;
}

TEST(EdgeDivision, MakesEqualSegmentsOfAboutTheWantedLength) {
  const DividedEdges divided = divide(testing::box(1, 2, 3), uniform(0.3));
  ASSERT_EQ(divided.edges.size(), 12u);
  for (const DividedEdge& edge : divided.edges) {
    const auto pieces = lengths(divided, edge);
    const double total = pieces.size() * pieces[0];
    EXPECT_EQ(pieces.size(), static_cast<std::size_t>(std::floor(total / 0.3 + 0.5)));
    for (const double piece : pieces) EXPECT_NEAR(piece, pieces[0], 1e-12);
  }
}

TEST(EdgeDivision, IsTheSameOnAnyThreads) {
  const Model box = testing::box(10, 10, 0.3);  // with strips beside its edges
  const SampledEdges sampled = sampleEdges(box.shape(), uniform(0.5), 1, {});
  const DividedEdges one = divideEdges(box.shape(), sampled, uniform(0.5), 1, {}),
                     many = divideEdges(box.shape(), sampled, uniform(0.5), 4, {});
  EXPECT_EQ(one.points, many.points);
  ASSERT_EQ(one.edges.size(), many.edges.size());
  for (std::size_t i = 0; i < one.edges.size(); ++i) {
    EXPECT_EQ(one.edges[i].points, many.edges[i].points);
    EXPECT_EQ(one.edges[i].parameters, many.edges[i].parameters);
  }
}

TEST(EdgeDivision, TellsAboutHowManySegmentsAreTooMany) {
  const Model box = testing::box(1, 1, 1);
  for (const auto& [size, told] : {std::pair(1e-12, "needs more than 1e+12 segments"),
                                   std::pair(1e-300, "needs more than 1e+300 segments")}) {
    CadSizes sizes = uniform(0.5);
    sizes.edgeSizes[1] = size;
    const std::string problem = sampleEdges(box.shape(), sizes, 1, {}).byFaces[0].problem;
    EXPECT_NE(problem.find(told), std::string::npos) << problem;
  }
}

TEST(EdgeDivision, SamplesDenselyOnlyWhereSizesAreTiny) {
  const Model box = testing::box(1, 2, 3);
  CadSizes sizes = uniform(1);
  sizes.function = [](const Point3& p) { return std::max(1e-6, 0.3 * length(p)); };
  const SampledEdges sampled = sampleEdges(box.shape(), sizes, 1, {});
  std::size_t most = 0;
  double shortest = 1;
  for (const EdgeSamples& samples : sampled.limited)
    for (const EdgePiece& piece : samples.pieces) {
      most = std::max(most, piece.parameters.size());
      shortest = std::min(shortest, piece.arcLength[1]);
    }
  EXPECT_LT(shortest, 2e-6);
  EXPECT_LT(most, 20000u) << "even spacing takes more than a million";
}

TEST(EdgeDivision, SharesTheVerticesOfTheModel) {
  const DividedEdges divided = divide(testing::box(1, 2, 3), uniform(100));
  std::set<std::uint32_t> used;
  for (const DividedEdge& edge : divided.edges) {
    ASSERT_EQ(edge.points.size(), 2u);
    used.insert(edge.points.begin(), edge.points.end());
  }
  EXPECT_EQ(used.size(), 8u);
}

TEST(EdgeDivision, TurnsByAtMostAnEighthOfACircleInOneSegment) {
  const DividedEdges divided = divide(testing::cylinder(1, 1), uniform(1.5));
  for (const DividedEdge& edge : divided.edges) {
    if (edge.points.empty() || edge.points.front() != edge.points.back()) continue;
    EXPECT_GE(edge.points.size(), 9u);
  }
}

TEST(EdgeDivision, KeepsRoundHolesRoundHoweverLargeTheSize) {
  const DividedEdges divided = divide(testing::cylinder(1, 1), uniform(1000));
  for (const DividedEdge& edge : divided.edges) {
    if (edge.points.empty() || edge.points.front() != edge.points.back()) continue;
    EXPECT_GE(edge.points.size(), 7u);
    EXPECT_LE(edge.points.size(), 16u);
  }
}

/// How many segments each arc of a sector of a cylinder has.
std::set<std::size_t> segmentsOfArcs(double radius, double degrees, double size, double perTurn) {
  CadSizes sizes = uniform(size);
  sizes.elementsPerTurn = perTurn;
  const Model model = testing::modelOf(
      BRepPrimAPI_MakeCylinder(radius, 1, degrees / 180 * std::numbers::pi).Shape());
  const DividedEdges divided = divide(model, spreadSizes(model.shape(), sizes, {}, 1, {}));
  std::set<std::size_t> segments;
  for (int id = 1; id <= model.edgeCount(); ++id)
    if (BRepAdaptor_Curve(TopoDS::Edge(model.shape().edge(id))).GetType() == GeomAbs_Circle)
      segments.insert(divided.edges[static_cast<std::size_t>(id) - 1].points.size() - 1);
  return segments;
}

TEST(EdgeDivision, TurnsByNoMoreThanWasAskedForInOneSegment) {
  for (const double degrees : {20.0, 31.0, 40.0, 70.0, 90.0, 100.0, 130.0, 180.0, 290.0})
    for (const double perTurn : {8.0, 12.0, 25.0})
      EXPECT_EQ(segmentsOfArcs(1, degrees, 5, perTurn),
                std::set{static_cast<std::size_t>(std::ceil(degrees * perTurn / 360 - 1e-9))})
          << degrees << " " << perTurn;
}

TEST(EdgeDivision, MakesNoSegmentThatTurnsLongerThanWantedIfTurnsHaveTheirElements) {
  const double degrees = 20, length = degrees / 180 * std::numbers::pi;
  EXPECT_EQ(segmentsOfArcs(1, degrees, length / 1.3, 12), std::set<std::size_t>{2});
  EXPECT_EQ(segmentsOfArcs(1, degrees, length / 2.2, 12), std::set<std::size_t>{3});
  EXPECT_EQ(segmentsOfArcs(1, degrees, length / 1.3, 0), std::set<std::size_t>{1});
  // All but straight: the nearest number.
  EXPECT_EQ(segmentsOfArcs(1, 2, length / 10 / 1.3, 12), std::set<std::size_t>{1});
}

TEST(EdgeDivision, GivesPolesNoSegments) {
  const DividedEdges divided = divide(testing::sphere(1), uniform(0.5));
  int empty = 0;
  for (const DividedEdge& edge : divided.edges) empty += edge.points.empty() ? 1 : 0;
  EXPECT_EQ(empty, 2);
}

TEST(EdgeDivision, PutsVerticesOntoTheCurve) {
  const DividedEdges divided = divide(testing::torus(3, 1), uniform(0.4));
  for (const Point3& p : divided.points) {
    const double r = std::sqrt(p.x * p.x + p.y * p.y) - 3;
    EXPECT_NEAR(std::sqrt(r * r + p.z * p.z), 1, 1e-12);
  }
}

TEST(EdgeDivision, TakesSizesByEdgeAndByTheFinerOfItsFaces) {
  CadSizes sizes = uniform(1);
  sizes.faceSizes[2] = 0.1;
  sizes.edgeSizes[1] = 0.05;
  const Model model = testing::box(1, 1, 1);
  const DividedEdges divided = divide(model, sizes);
  EXPECT_EQ(divided.edges[0].points.size(), 21u);
  int fine = 0;
  for (const DividedEdge& edge : divided.edges) fine += edge.points.size() >= 11 ? 1 : 0;
  EXPECT_GE(fine, 4);
}

TEST(EdgeDivision, FollowsASizeFunctionAlongTheEdge) {
  CadSizes sizes = uniform(1);
  sizes.function = [](const Point3& p) { return 0.1 + 0.1 * p.z; };
  const DividedEdges divided = divide(testing::box(2, 2, 10), sizes);
  for (const DividedEdge& edge : divided.edges) {
    if (edge.points.size() < 4) continue;
    for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) {
      const Point3 &p = divided.points[edge.points[i]], &q = divided.points[edge.points[i + 1]];
      EXPECT_NEAR(distance(p, q), 0.1 + 0.05 * (p.z + q.z), 0.12 * distance(p, q));
    }
  }
}

}  // namespace
}  // namespace af2::geometry
