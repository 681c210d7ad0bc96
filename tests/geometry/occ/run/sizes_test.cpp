// Sizes that are asked for, on CAD models.
#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Cylinder.hxx>

#include <cmath>
#include <map>
#include <numbers>

#include "engine/base/error.h"
#include "geometry/mesh/fingerprint.h"
#include "geometry/occ/run/mesh_model.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/mesh_edges.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

MeshingOptions optionsOf(const Sizes& sizes) {
  MeshingOptions options = testing::ofSize(sizes.size);
  options.sizes = sizes;
  return options;
}

ModelMesh mesh(const Model& model, const Sizes& sizes) {
  ModelMesh result = testing::mesh(model, optionsOf(sizes));
  testing::expectComplete(result);
  return result;
}

Sizes sizesOf(double size) {
  Sizes sizes;
  sizes.size = size;
  return sizes;
}

std::map<int, int> segmentsByEdge(const ModelMesh& mesh) {
  std::map<int, int> count;
  for (const EdgeSegment& segment : mesh.segments) ++count[segment.edge];
  return count;
}

double meanLength(const ModelMesh& mesh) {
  double sum = 0;
  const std::vector<testing::MeshEdge> edges = testing::meshEdges(mesh);
  for (const testing::MeshEdge& edge : edges)
    sum += distance(mesh.vertices[edge.from.value], mesh.vertices[edge.to.value]);
  return sum / static_cast<double>(edges.size());
}

/// The longest edge at each vertex over the shortest one, at its worst.
double worstStep(const ModelMesh& mesh) {
  std::vector<double> shortest(mesh.vertices.size(), 1e300), longest(mesh.vertices.size(), 0);
  for (const testing::MeshEdge& edge : testing::meshEdges(mesh)) {
    const double length = distance(mesh.vertices[edge.from.value], mesh.vertices[edge.to.value]);
    for (const VertexId v : {edge.from, edge.to}) {
      shortest[v.value] = std::min(shortest[v.value], length);
      longest[v.value] = std::max(longest[v.value], length);
    }
  }
  double worst = 1;
  for (std::size_t v = 0; v < shortest.size(); ++v)
    if (longest[v] > 0) worst = std::max(worst, longest[v] / shortest[v]);
  return worst;
}

TEST(Sizes, GiveATurnTheElementsThatAreAskedFor) {
  // A ball with fewer would lose more than a twentieth of its area, and get more after all.
  for (const double turn : {15.0, 30.0}) {
    Sizes sizes = sizesOf(3);
    sizes.elementsPerTurn = turn;
    sizes.minSize = 0.01;
    const ModelMesh ball = mesh(testing::sphere(1), sizes);
    EXPECT_NEAR(meanLength(ball), 2 * std::numbers::pi / turn, 0.2 / turn * 2 * std::numbers::pi);
    int circles = 0;
    for (const auto& [edge, count] : segmentsByEdge(mesh(testing::cylinder(1, 2), sizes)))
      if (count == turn) ++circles;
    EXPECT_EQ(circles, 2);
  }
}

TEST(Sizes, LeaveRoomForScatterOnCurvedFacesAndTheirEdges) {
  Sizes sizes = sizesOf(1);
  const auto longest = [&] {
    int most = 0;
    for (const auto& [edge, count] : segmentsByEdge(mesh(testing::cylinder(10, 20), sizes)))
      most = std::max(most, count);
    return most;
  };
  EXPECT_EQ(longest(), 63);
  sizes.elementsPerTurn = 12;
  EXPECT_EQ(longest(), 70);  // 63 / 0.9
}

TEST(Sizes, FollowAThinTubeHoweverManyElementsATurnIsToHave) {
  Sizes sizes = sizesOf(100);
  std::size_t before = 0;
  for (const double turn : {10.0, 14.0, 20.0}) {
    sizes.elementsPerTurn = turn;
    const std::size_t elements = mesh(testing::cylinder(1, 30), sizes).elements.size();
    EXPECT_GT(elements, before) << turn;
    before = elements;
  }
}

TEST(Sizes, LeaveNoneOnFacesThatAreAsGoodAsFlat) {
  Sizes sizes = sizesOf(1);
  sizes.elementsPerTurn = 12;
  const TopoDS_Face face =
      BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(), 1e4), 0, 1e-3, 0, 10).Face();
  for (const auto& [edge, count] : segmentsByEdge(mesh(testing::modelOf(face), sizes)))
    EXPECT_EQ(count, 10);
}

TEST(Sizes, StopAtTheSmallestAndTheLargest) {
  Sizes sizes = sizesOf(5);
  sizes.elementsPerTurn = 100;
  sizes.minSize = 0.3;
  EXPECT_NEAR(meanLength(mesh(testing::sphere(1), sizes)), 0.3, 0.05);
  sizes = sizesOf(5);
  sizes.maxSize = 0.25;
  sizes.faceSizes[1] = 4;
  EXPECT_NEAR(meanLength(mesh(testing::box(1, 1, 1), sizes)), 0.25, 0.04);
  sizes.minSize = 1;
  EXPECT_THROW(mesh(testing::box(1, 1, 1), sizes), InputError);
}

TEST(Sizes, BelowTheSmallestAreTold) {
  Sizes sizes = sizesOf(0.25);
  const auto isTold = [&] {
    const ModelMesh made = mesh(testing::box(1, 1, 1), sizes);
    return std::ranges::any_of(made.notes, [](const std::string& note) {
      return note.find("allowed, 0.5, although 0.25 was asked for") != std::string::npos;
    });
  };
  EXPECT_FALSE(isTold());
  sizes.minSize = 0.5;
  EXPECT_TRUE(isTold());
}

TEST(Sizes, AtAPointSpreadEvenlyThroughSpace) {
  Sizes sizes = sizesOf(1);
  sizes.sources.points = {{{5, 5, 2}, 0.05}};
  sizes.growth = 0.3;
  const ModelMesh result = mesh(testing::box(10, 10, 2), sizes);
  EXPECT_LT(worstStep(result), 3);
  double nearest = 1e300, farthest = 0;
  for (const testing::MeshEdge& edge : testing::meshEdges(result)) {
    const Point3 &p = result.vertices[edge.from.value], &q = result.vertices[edge.to.value];
    const double reach = distance(0.5 * (p + q), Point3{5, 5, 2});
    if (reach < 0.1) nearest = std::min(nearest, distance(p, q));
    if (reach > 5) farthest = std::max(farthest, distance(p, q));
  }
  EXPECT_LT(nearest, 0.1);
  EXPECT_GT(farthest, 0.8);
}

/// Fronts are not stopped, although the size of the model and a few samples let expect few
/// elements.
TEST(Sizes, AtPointsMayWantFarMoreElementsThanSamplesTell) {
  Sizes sizes = sizesOf(20);
  for (int i = 0; i < 64; ++i)
    sizes.sources.points.push_back({{18.6 + 0.4 * (i % 8), 18.6 + 0.4 * (i / 8), 1}, 0.001});
  const ModelMesh result = mesh(testing::box(40, 40, 1), sizes);
  for (const FaceReport& face : result.faces) EXPECT_EQ(face.status, FaceStatus::Complete);
  EXPECT_GT(result.elements.size(), 20'000u);
}

/// The mean length of edges between these distances from the z axis.
double meanLengthAround(const ModelMesh& mesh, double from, double to) {
  double sum = 0;
  int count = 0;
  for (const testing::MeshEdge& edge : testing::meshEdges(mesh)) {
    const Point3 &p = mesh.vertices[edge.from.value], &q = mesh.vertices[edge.to.value];
    const double radius = std::hypot((p.x + q.x) / 2, (p.y + q.y) / 2);
    if (radius < from || radius > to) continue;
    sum += distance(p, q);
    ++count;
  }
  return sum / count;
}

TEST(Sizes, GrowAwayFromACurvedFaceMoreGentlyThanTheyMay) {
  const gp_Ax2 below(gp_Pnt(0, 0, -1), gp_Dir(0, 0, 1));
  const Model plate =
      testing::modelOf(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(-8, -8, 0), 16, 16, 1).Shape(),
                                       BRepPrimAPI_MakeCylinder(below, 0.4, 3).Shape())
                           .Shape());
  Sizes sizes = sizesOf(2);
  sizes.elementsPerTurn = 12;
  const double atHole = 2 * std::numbers::pi * 0.4 / 12;
  for (const double growth : {0.3, 0.45}) {
    sizes.growth = growth;
    const double mean = meanLengthAround(mesh(plate, sizes), 3, 4);
    const double most = growth * (3.5 - 0.4);
    EXPECT_GT(mean, atHole + 0.6 * most);
    EXPECT_LT(mean, atHole + 1.2 * most);  // edges are longer than the size where it falls
  }
}

TEST(Sizes, InABoxAreKeptOnEdgesAndFaces) {
  Sizes sizes = sizesOf(1);
  sizes.sources.boxes = {{{0, 0, 0}, {1, 1, 4}, 0.1}};
  const ModelMesh result = mesh(testing::box(4, 4, 4), sizes);
  std::size_t inside = 0;
  for (const testing::MeshEdge& edge : testing::meshEdges(result)) {
    const Point3 &p = result.vertices[edge.from.value], &q = result.vertices[edge.to.value];
    if (std::max({p.x, p.y, q.x, q.y}) > 0.9) continue;
    ++inside;
    EXPECT_LT(distance(p, q), 0.18);
  }
  EXPECT_GT(inside, 1000u);
  EXPECT_LT(worstStep(result), 3);
}

TEST(Sizes, PutElementsAcrossAThinPlate) {
  Sizes sizes = sizesOf(1);
  sizes.elementsAcross = 2;
  const ModelMesh plate = mesh(testing::box(4, 4, 0.5), sizes);
  EXPECT_NEAR(meanLength(plate), 0.25, 0.05);
  // One of its edges of length 0.5 has two segments.
  for (const auto& [edge, count] : segmentsByEdge(plate)) EXPECT_GE(count, 2);
  EXPECT_NEAR(meanLength(mesh(testing::box(4, 4, 4), sizes)), 1, 0.2) << "nothing narrow here";
  sizes.minSize = 0.4;
  EXPECT_NEAR(meanLength(mesh(testing::box(4, 4, 0.5), sizes)), 0.4, 0.06);
}

TEST(Sizes, AreToldForEachVertex) {
  Sizes sizes = sizesOf(1);
  sizes.faceSizes[1] = 0.5;
  sizes.edgeSizes[5] = 0.125;
  sizes.sources.points = {{{2, 2, 2}, 0.25}};
  const ModelMesh result = mesh(testing::box(2, 2, 2), sizes);
  ASSERT_EQ(result.wantedSizes.size(), result.vertices.size());
  for (std::size_t v = 0; v < result.vertices.size(); ++v) {
    EXPECT_GT(result.wantedSizes[v], 0.1);
    EXPECT_LE(result.wantedSizes[v], 0.25 + 0.4 * distance(result.vertices[v], {2, 2, 2}) + 1e-12);
  }
  for (std::size_t e = 0; e < result.elements.size(); ++e)
    for (const VertexId v : result.elements[e].vertices())
      EXPECT_LE(result.wantedSizes[v.value], result.face[e] == 1 ? 0.5 : 1);
  for (const EdgeSegment& segment : result.segments)
    EXPECT_LE(result.wantedSizes[segment.from.value], segment.edge == 5 ? 0.125 : 1);
}

TEST(Sizes, OfAFunctionReachTheFacesAroundThem) {
  // Small inside one face only: without spreading, the edges would not know.
  Sizes sizes = sizesOf(1);
  sizes.function = [](const Point3& p) { return distance(p, Point3{2, 2, 4}) < 1 ? 0.05 : 10.0; };
  const ModelMesh result = mesh(testing::box(4, 4, 4), sizes);
  EXPECT_LT(worstStep(result), 4.5);
}

TEST(Sizes, OfAtLeastSoMuchLeaveSmallHolesAndPinsFourElementsAround) {
  // With three, the walls of the hole and of the pin failed.
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(100, 100, 5).Shape();
  const auto cylinder = [](double x, double z, double radius) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2({x, 50, z}, {0, 0, 1}), radius, 7).Shape();
  };
  const TopoDS_Shape part =
      BRepAlgoAPI_Fuse(BRepAlgoAPI_Cut(plate, cylinder(50, -1, 0.2)).Shape(), cylinder(30, 4, 0.06))
          .Shape();
  Sizes sizes = sizesOf(5);
  sizes.minSize = 0.5;
  for (const double turn : {0.0, 12.0}) {
    sizes.elementsPerTurn = turn;
    int circles = 0;
    for (const auto& [edge, count] : segmentsByEdge(mesh(testing::modelOf(part), sizes)))
      if (count == 4) ++circles;
    EXPECT_EQ(circles, 4);
  }
}

TEST(Sizes, NoSizeIsLargerThanTheModel) {
  Sizes sizes, asLargeAsTheModel;
  const Model model = testing::cylinder(1, 2);
  asLargeAsTheModel.size = asLargeAsTheModel.minSize = model.diagonal();
  sizes.size = 1e15;
  sizes.minSize = 1e12;
  EXPECT_EQ(fingerprint(mesh(model, sizes)), fingerprint(mesh(model, asLargeAsTheModel)));
}

TEST(Sizes, ThatAskForTooManyElementsAreRefused) {
  const Model model = testing::box(10, 10, 10);
  Sizes boxed = sizesOf(1);
  boxed.sources.boxes.push_back({{0, 0, 0}, {10, 10, 5}, 1e-6});
  EXPECT_THROW(testing::mesh(model, optionsOf(boxed)), InputError);
  boxed.minSize = 0.5;
  EXPECT_NO_THROW(testing::mesh(model, optionsOf(boxed)));

  Sizes turned = sizesOf(1);
  turned.elementsPerTurn = 1e7;
  turned.minSize = 1e-6;
  EXPECT_THROW(testing::mesh(testing::cylinder(3, 9), optionsOf(turned)), InputError);
}

/// Too much of the area is cut off, but shorter edges are not to be had.
TEST(Sizes, AreNotTriedBelowTheLeast) {
  const gp_Ax2 axes(gp_Pnt(0, 0, 0), gp::DZ());
  const Model quarter =
      testing::modelOf(BRepPrimAPI_MakeCylinder(axes, 1, 20, std::numbers::pi / 2).Shape());
  Sizes sizes = sizesOf(1.6);
  sizes.minSize = 1.6;
  const ModelMesh coarse = mesh(quarter, sizes);
  for (const FaceReport& face : coarse.faces)
    EXPECT_TRUE(face.attempts.empty()) << face.id << ": " << face.attempts.front();
  sizes.minSize = 0;
  EXPECT_GT(mesh(quarter, sizes).elements.size(), coarse.elements.size());
}

/// Also far away from the origins of the planes, at the corner of the box.
TEST(SizeFunction, ThatAsksForTooManyElementsIsRefusedWhereverItDoes) {
  const Model box = testing::box(10, 10, 10);
  for (const double at : {1., 5., 9.}) {
    Sizes sizes = sizesOf(5);
    sizes.function = [at](const Point3& p) { return distance(p, {at, at, 10}) < 2 ? 1e-4 : 5; };
    EXPECT_THROW(mesh(box, sizes), InputError) << at;
  }
}

}  // namespace
}  // namespace af2::geometry
