#include "geometry/congruence/moved_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/geometry/congruence/motions.h"

namespace af2::geometry {
namespace {

using testing::kAway, testing::kMirror, testing::kStill;

const std::vector<Point3> kPlaces = {{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 1, 0}};
const Point3 kInside{1, 0.5, 0};

/// A quadrangle in the plane z = 0, moved. Vertex 0 is at the first place, 1 at the second, ...
FaceOutline outline(const Motion& motion, bool isBackwards = false) {
  FrontInput input;
  auto& loop = input.loops.emplace_back();
  const Point3 normal = motion.turned({0, 0, 1}), place = motion.moved({0, 0, 0});
  for (std::size_t i = 0; i < kPlaces.size(); ++i) {
    const std::size_t k = isBackwards ? kPlaces.size() - 1 - i : i;
    loop.push_back({VertexId(i), {motion.moved(kPlaces[k]), normal, 0, 0}});
  }
  input.vertexCount = kPlaces.size();
  FaceOutline outline;
  outline.form = formOf(std::move(input));
  outline.points = {20, 21, 22, 23};
  outline.uses = {{7, 0}};
  outline.numbers = {1, 2};
  outline.distance = [=](const Point3& p) { return std::abs(dot(p - place, normal)); };
  return outline;
}

/// Four triangles around a vertex.
FaceMesh mesh() {
  FaceMesh mesh;
  mesh.report.id = 3;
  mesh.report.chart = "plane";
  mesh.report.elements = 4;
  mesh.boundary = {10, 11, 12, 13};
  mesh.inside = {kInside};
  mesh.wantedSizes = {1, 2, 3, 4, 5};
  for (std::size_t i = 0; i < 4; ++i)
    mesh.elements.push_back({{VertexId(i), VertexId((i + 1) % 4), VertexId(4)}});
  mesh.origins.resize(4);
  mesh.searchCost = 77;
  return mesh;
}

std::vector<Point3> placesOf(const FaceOutline& outline, const FaceMesh& mesh) {
  std::vector<Point3> places(4);
  for (const BoundaryCorner& corner : outline.form.input.loops[0])
    places[corner.vertex.value] = corner.point.position;
  places.insert(places.end(), mesh.inside.begin(), mesh.inside.end());
  return places;
}

/// Of the elements, as seen along a direction.
double areaAlong(const Point3& normal, const FaceOutline& outline, const FaceMesh& mesh) {
  const std::vector<Point3> places = placesOf(outline, mesh);
  double area = 0;
  for (const Element& element : mesh.elements) {
    const auto at = [&](std::size_t i) { return places[element.corners[i].value]; };
    const double own = dot(normal, cross(at(1) - at(0), at(2) - at(0))) / 2;
    EXPECT_GT(own, 0);
    area += own;
  }
  return area;
}

TEST(MovedMesh, LiesOnTheOtherFace) {
  const FaceOutline one = outline(kStill), other = outline(kAway);
  const FaceMesh own = mesh();
  FaceMesh moved;
  moved.report.id = 8;
  moved.report.name = "other";
  ASSERT_TRUE(MovableMesh(one, own).moveTo(other, moved));
  EXPECT_NEAR(areaAlong(kAway.turned({0, 0, 1}), other, moved), 4.5, 1e-12);
  EXPECT_LT(distance(moved.inside.at(0), kAway.moved(kInside)), 1e-12);
  EXPECT_EQ(moved.boundary, other.points);
  EXPECT_EQ(moved.uses.size(), 1u);
  EXPECT_EQ(moved.report.id, 8);
  EXPECT_EQ(moved.report.name, "other");
  EXPECT_EQ(moved.report.congruentTo, 3);
  EXPECT_EQ(moved.report.chart, "plane");
  EXPECT_EQ(moved.report.elements, 4u);
  EXPECT_EQ(moved.searchCost, 77u);
}

TEST(MovedMesh, LooksTheSameWayInAMirror) {
  const FaceOutline one = outline(kStill), other = outline(kMirror, true);
  FaceMesh own = mesh(), moved;
  for (const Element& element : own.elements) {
    SideMiddles& middles = own.middles.emplace_back();
    const std::vector<Point3> places = placesOf(one, own);
    for (std::size_t i = 0; i < 3; ++i)
      middles[i] =
          0.5 * (places[element.corners[i].value] + places[element.corners[(i + 1) % 3].value]);
  }
  ASSERT_TRUE(MovableMesh(one, own).moveTo(other, moved));
  EXPECT_NEAR(areaAlong({0, 0, 1}, other, moved), 4.5, 1e-12);
  EXPECT_EQ(moved.wantedSizes, (std::vector<double>{4, 3, 2, 1, 5}));
  const std::vector<Point3> places = placesOf(other, moved);
  for (std::size_t e = 0; e < 4; ++e)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& corners = moved.elements[e].corners;
      const Point3 middle = 0.5 * (places[corners[i].value] + places[corners[(i + 1) % 3].value]);
      EXPECT_LT(distance(moved.middles[e][i], middle), 1e-12);
    }
}

TEST(MovedMesh, MovesPlacesThatAskForShorterEdges) {
  const FaceOutline one = outline(kStill), other = outline(kAway);
  FaceMesh own = mesh(), moved;
  own.diagnosis.poorness = 2;
  own.diagnosis.places = {{kInside, 0.1}};
  ASSERT_TRUE(MovableMesh(one, own).moveTo(other, moved));
  EXPECT_EQ(moved.diagnosis.poorness, 2);
  EXPECT_LT(distance(moved.diagnosis.places.at(0).position, kAway.moved(kInside)), 1e-12);
}

TEST(MovedMesh, NeedsTheSameNumbersAndHistory) {
  const FaceOutline one = outline(kStill);
  FaceOutline other = outline(kAway);
  FaceMesh own = mesh(), moved;
  other.history = {note("its own")};
  EXPECT_TRUE(MovableMesh(one, own).moveTo(other, moved));
  EXPECT_EQ(moved.history, other.history);
  own.history = {note("of a try")};
  EXPECT_FALSE(MovableMesh(one, own).moveTo(other, moved));
  own.history.clear();
  other.numbers[1] = 3;
  EXPECT_FALSE(MovableMesh(one, own).moveTo(other, moved));
}

TEST(MovedMesh, NeedsVerticesOnTheSurface) {
  const FaceOutline one = outline(kStill);
  FaceOutline other = outline(kAway);
  other.distance = [](const Point3& p) { return distance(p, kAway.moved(kInside)) < 1 ? 1e-6 : 0; };
  const FaceMesh own = mesh();
  FaceMesh moved;
  EXPECT_FALSE(MovableMesh(one, own).moveTo(other, moved));
}

TEST(MovedMesh, NeedsTheSameSizesByPosition) {
  FaceOutline one = outline(kStill), other = outline(kAway);
  FaceMesh own = mesh(), moved;
  own.wantedSizes.assign(5, 1);
  const auto isMovable = [&](const PositionSize& sizes) {
    one.sizes = other.sizes = sizes;
    return MovableMesh(one, own).moveTo(other, moved);
  };
  const auto atOther = [](double size) {
    return PositionSize([size](const Point3& p) { return p.z > 2 ? size : 1.; });
  };
  EXPECT_TRUE(isMovable(atOther(1)));
  EXPECT_TRUE(isMovable(atOther(0.995)));
  EXPECT_FALSE(isMovable(atOther(0.9)));
  EXPECT_FALSE(isMovable(PositionSize([](const Point3& p) { return p.z > 2 ? 2 : 0.9; })));
  // Sizes above what the face wants anyway do not matter.
  EXPECT_TRUE(isMovable(PositionSize([](const Point3& p) { return p.z > 2 ? 2 : 3; })));
  const Point3 inside = kAway.moved(kInside);
  EXPECT_FALSE(isMovable(
      PositionSize([inside](const Point3& p) { return distance(p, inside) < 0.1 ? 0.5 : 1.; })));
}

TEST(MovedMesh, IsThatOfACompleteFace) {
  FaceMesh own = mesh();
  EXPECT_TRUE(MovableMesh::isMovable(own));
  own.report.oddLoops = {{1, 3, {}}};
  EXPECT_TRUE(MovableMesh::isMovable(own));
  own.report.oddLoops[0].longest.sizes = 1;
  EXPECT_FALSE(MovableMesh::isMovable(own));
  own = mesh();
  own.report.status = FaceStatus::Failed;
  EXPECT_FALSE(MovableMesh::isMovable(own));
  EXPECT_FALSE(MovableMesh::isMovable(FaceMesh()));
}

}  // namespace
}  // namespace af2::geometry
