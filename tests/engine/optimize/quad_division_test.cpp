// That triangles which cannot be joined become quadrilaterals by division of what lies between.
#include "engine/optimize/quad_division.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/mesh/element_measures.h"
#include "engine/mesh/mesh_check.h"
#include "engine/optimize/optimize.h"
#include "tests/support/flat_surface.h"
#include "tests/support/meshing.h"

namespace af2 {
namespace {

using namespace af2::testing;

/// A mesh without inner vertices.
struct Outlined {
  FrontInput input;
  Mesh mesh;

  explicit Outlined(const std::vector<Point2>& outline) {
    addLoop(input, outline);
    for (const BoundaryCorner& c : input.loops[0]) mesh.vertices.push_back(c.point);
  }
  void add(std::initializer_list<std::size_t> corners) {
    Element element;
    std::ranges::transform(corners, element.corners.begin(),
                           [](std::size_t v) { return VertexId(v); });
    mesh.elements.push_back(element);
    mesh.origins.emplace_back();
  }
};

/// A strip one element wide, from (0, 0) to (n, width), with a triangle at both ends.
Outlined stripWithTips(std::size_t n, double width) {
  std::vector<Point2> outline{{-1, width / 2}};
  for (std::size_t i = 0; i <= n; ++i) outline.push_back({static_cast<double>(i), 0});
  outline.push_back({static_cast<double>(n) + 1, width / 2});
  for (std::size_t i = 0; i <= n; ++i) outline.push_back({static_cast<double>(n - i), width});
  Outlined strip(outline);
  const auto low = [](std::size_t i) { return 1 + i; };
  const auto high = [n](std::size_t i) { return 2 * n + 3 - i; };
  strip.add({0, low(0), high(0)});
  for (std::size_t i = 0; i < n; ++i) strip.add({low(i), low(i + 1), high(i + 1), high(i)});
  strip.add({low(n), n + 2, high(n)});
  return strip;
}

/// Joins the triangles; the mesh must be sound, with the same area and boundary, before and after.
void expectOnlyQuads(Outlined& outlined, std::size_t pairs = 1) {
  ASSERT_EQ(faultOf(outlined.mesh, boundaryOf(outlined.input)), "");
  const double area = testing::areaOf(outlined.mesh);
  EXPECT_EQ(joinTriangles(outlined.mesh, boundaryOf(outlined.input), FlatMaker()), pairs);
  EXPECT_TRUE(checkMesh(outlined.mesh, outlined.input).empty());
  EXPECT_NEAR(testing::areaOf(outlined.mesh), area, 1e-9 * area);
  EXPECT_TRUE(std::ranges::all_of(outlined.mesh.elements, &Element::isQuad));
}

/// The elements of a strip of four quadrilaterals after `divide(editor)`.
template <class Divide>
std::vector<Element> divided(const Divide& divide) {
  Outlined strip = stripWithTips(4, 0.8);
  const double area = testing::areaOf(strip.mesh);
  MeshTopology topology(strip.mesh, boundaryOf(strip.input));
  const FlatMaker maker;
  PatchEditor editor(topology, maker, topology.anglesAtFixed());
  EXPECT_TRUE(divide(editor));
  topology.compact();
  EXPECT_TRUE(checkMesh(strip.mesh, strip.input).empty());
  EXPECT_NEAR(testing::areaOf(strip.mesh), area, 1e-9);
  return strip.mesh.elements;
}

TEST(QuadDivision, DividesSlivers) {
  Outlined strip = stripWithTips(5, 0.0005);
  expectOnlyQuads(strip);
}

TEST(QuadDivision, DividesAStripLengthwise) {
  const std::vector<std::size_t> path{0, 1, 2, 3, 4, 5};
  const std::vector<Element> elements =
      divided([&](PatchEditor& editor) { return divideAlong(editor, path, std::nullopt, 0.1); });
  EXPECT_EQ(elements.size(), 10u);
  EXPECT_TRUE(std::ranges::all_of(elements, &Element::isQuad));
}

TEST(QuadDivision, MovesTheTriangleToTheEndOfThePart) {
  const std::vector<std::size_t> part{0, 1, 2};
  const std::vector<Element> elements =
      divided([&](PatchEditor& editor) { return divideAlong(editor, part, 3, 0.1); });
  EXPECT_EQ(elements.size(), 8u);
  EXPECT_EQ(std::ranges::count_if(elements, &Element::isQuad), 6);
}

TEST(QuadDivision, GoesAnyDistanceInStages) {
  for (const int quads : {23, 24, 25, 90}) {  // of 24, the last stage begins beside the other end
    SCOPED_TRACE(quads);
    Outlined strip = stripWithTips(quads, 0.8);
    expectOnlyQuads(strip);
    Outlined reversed = stripWithTips(quads, 0.8);
    std::ranges::reverse(reversed.mesh.elements);
    expectOnlyQuads(reversed);
  }
}

TEST(QuadDivision, RefusesWaysThatReturn) {
  Outlined strip = stripWithTips(4, 0.8);
  MeshTopology topology(strip.mesh, boundaryOf(strip.input));
  const FlatMaker maker;
  PatchEditor editor(topology, maker, topology.anglesAtFixed());
  EXPECT_FALSE(divideAlong(editor, std::vector<std::size_t>{0, 1, 0}, std::nullopt, 0.1));
}

// Tips are then sharper than any quadrilateral should be, which nothing can change.
TEST(QuadDivision, StripsMayBeNarrow) {
  for (const double width : {0.05, 0.01}) {
    SCOPED_TRACE(width);
    Outlined strip = stripWithTips(6, width);
    expectOnlyQuads(strip);
  }
}

// Two strips that touch with a tip.
TEST(QuadDivision, TwoTipsMayHaveTheirVertexInCommon) {
  const Outlined strip = stripWithTips(6, 0.02);
  const auto& loop = strip.input.loops[0];
  std::vector<Point2> outline;
  for (const BoundaryCorner& c : loop) outline.push_back({c.point.position.x, c.point.position.y});
  const std::size_t count = outline.size();
  const Point2 tip = outline[0];
  for (std::size_t v = 1; v < count; ++v)  // turned by half a turn around the tip
    outline.push_back(2.0 * tip - outline[v]);
  Outlined both(outline);
  const BoundaryCorner touching = both.input.loops[0][0];
  both.input.loops[0].insert(both.input.loops[0].begin() + static_cast<std::ptrdiff_t>(count),
                             touching);
  both.mesh.elements = strip.mesh.elements;
  for (Element element : strip.mesh.elements) {
    for (VertexId& v : element.corners)
      if (!v.isNone() && v.value > 0) v = VertexId(v.value + count - 1);
    both.mesh.elements.push_back(element);
  }
  both.mesh.origins.resize(both.mesh.elements.size());
  expectOnlyQuads(both, 2);
}

/// Without a quadrilateral between them, and with an outline that is straight at a vertex.
TEST(QuadDivision, TwoTrianglesAloneGetARing) {
  Outlined triangle({{0, 0}, {1, 0}, {2, 0}, {1, 1.7}});
  triangle.add({0, 1, 3});
  triangle.add({1, 2, 3});
  expectOnlyQuads(triangle);
  EXPECT_EQ(triangle.mesh.elements.size(), 5u);
}

/// A strip with one segment more on one side at each of two places; the triangles share a side.
TEST(QuadDivision, TrianglesBesideEachOtherGoApartFirst) {
  Outlined strip(
      {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}, {5, 0.8}, {3, 0.8}, {1, 0.8}, {0, 0.8}});
  strip.add({0, 1, 8, 9});
  strip.add({1, 2, 8});
  strip.add({2, 3, 7, 8});
  strip.add({3, 4, 7});
  strip.add({4, 5, 6, 7});
  expectOnlyQuads(strip);

  Outlined fan({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {4, 0.8}, {2, 0.8}, {0, 0.8}});
  fan.add({0, 1, 6, 7});
  fan.add({1, 2, 6});
  fan.add({2, 3, 6});
  fan.add({3, 4, 5, 6});
  expectOnlyQuads(fan);
}

/// An odd boundary keeps one triangle, and nothing changes.
TEST(QuadDivision, ATriangleAloneStays) {
  Outlined outlined({{0, 0}, {1, 0}, {2, 0.4}, {1, 0.8}, {0, 0.8}});
  outlined.add({0, 1, 3, 4});
  outlined.add({1, 2, 3});
  const std::vector<Element> before = outlined.mesh.elements;
  EXPECT_EQ(joinTriangles(outlined.mesh, boundaryOf(outlined.input), FlatMaker()), 0u);
  EXPECT_EQ(outlined.mesh.elements, before);
}

/// An L of three squares with a triangle on each of its ends; the triangles in both orders, so that
/// the way turns to the left and to the right.
TEST(QuadDivision, TheWayMayTurn) {
  for (const bool isLeft : {true, false}) {
    Outlined corner(
        {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1.5, 2.8}, {1, 2}, {1, 1}, {0, 1}, {-0.8, 0.5}});
    corner.add({0, 1, 7, 8});
    corner.add({1, 2, 3, 7});
    corner.add({7, 3, 4, 6});
    if (isLeft) corner.add({4, 5, 6});
    corner.add({0, 8, 9});
    if (!isLeft) corner.add({4, 5, 6});
    expectOnlyQuads(corner);
  }
}

/// The least scaled Jacobian of a mesh in the plane.
double leastJacobian(const Mesh& mesh) {
  double least = 1;
  for (const Element& element : mesh.elements) {
    std::vector<Point2> points;
    for (const VertexId v : element.vertices()) {
      const Point3& p = mesh.vertices[v.value].position;
      points.push_back({p.x, p.y});
    }
    least = std::min(least, scaledJacobian(points));
  }
  return least;
}

std::size_t countDividedFlatQuads(Outlined& outlined) {
  MeshTopology topology(outlined.mesh, boundaryOf(outlined.input));
  const FlatMaker maker;
  PatchEditor editor(topology, maker, topology.anglesAtFixed());
  const std::size_t divided = divideFlatQuads(editor, {});
  topology.compact();
  EXPECT_TRUE(checkMesh(outlined.mesh, outlined.input).empty());
  return divided;
}

TEST(QuadDivision, FlatQuadsAreDividedWhereTheBoundaryIsNearlyStraight) {
  Outlined flat({{0, 0}, {1, -0.1}, {2, 0}, {1, 1.7}});
  flat.add({0, 1, 2, 3});
  const double before = leastJacobian(flat.mesh);
  EXPECT_LT(before, 0.25);
  EXPECT_EQ(countDividedFlatQuads(flat), 1u);
  EXPECT_EQ(flat.mesh.elements.size(), 5u);
  EXPECT_GT(leastJacobian(flat.mesh), before + 0.1);
}

/// Its sharp corner cannot become wider.
TEST(QuadDivision, SharpOnesStay) {
  Outlined sharp({{0, 0}, {1, -0.1}, {1.1, 0}, {1, 0.1}});
  sharp.add({0, 1, 2, 3});
  EXPECT_EQ(countDividedFlatQuads(sharp), 0u);
  EXPECT_EQ(sharp.mesh.elements.size(), 1u);
}

}  // namespace
}  // namespace af2
