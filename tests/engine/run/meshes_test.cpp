// Whole meshes of flat regions with the classical triangle rules.
#include <gtest/gtest.h>

#include <functional>

#include "tests/support/meshing.h"

namespace af2 {
namespace {

using namespace af2::testing;
using Points = std::vector<Point2>;

void addHole(FrontInput& input, Points counterClockwise) {
  std::reverse(counterClockwise.begin(), counterClockwise.end());
  addLoop(input, counterClockwise);
}

/// The same region, every point moved.
FrontInput moved(FrontInput input, const std::function<Point2(Point2)>& move) {
  const auto moveCorner = [&](BoundaryCorner& corner) {
    const Point3 p = corner.point.position;
    corner = flatCorner(corner.vertex.value, move({p.x, p.y}));
  };
  for (auto& loop : input.loops)
    for (BoundaryCorner& corner : loop) moveCorner(corner);
  for (BoundaryCorner& corner : input.isolated) moveCorner(corner);
  return input;
}

Points star(int points, double inner, double outer) {
  Points result;
  for (int i = 0; i < 2 * points; ++i) {
    const double t = M_PI * i / points, r = i % 2 ? inner : outer;
    result.push_back(r * Point2{std::cos(t), std::sin(t)});
  }
  return result;
}

Points comb(int teeth, double width, double gap, double height) {
  Points result{{0, -.2}, {teeth * (width + gap) - gap, -.2}};
  for (int i = teeth - 1; i >= 0; --i) {
    const double left = i * (width + gap), right = left + width;
    if (i < teeth - 1) result.push_back({right, 0});
    result.push_back({right, height});
    result.push_back({left, height});
    if (i > 0) result.push_back({left, 0});
  }
  return result;
}

TEST(Meshes, Square) {
  for (double size : {1.0, .5, .25, .1, .03}) {
    const FrontInput input = square(size);
    expectGoodMesh(meshFlat(input, size), input, .15);
  }
}

TEST(Meshes, DiscWithAHole) {
  for (double size : {.1, .03, .0125}) {
    const FrontInput input = discWithHole(size);
    expectGoodMesh(meshFlat(input, size), input, .1);
  }
}

TEST(Meshes, Annulus) {
  FrontInput input;
  addLoop(input, circle({3, 4}, 1, 60));
  addLoop(input, circle({3, 4}, .9, 54, true));
  expectGoodMesh(meshFlat(input, .105), input, .1);
}

TEST(Meshes, LShape) {
  const double size = .07;
  FrontInput input;
  addLoop(input, divided({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, size));
  expectGoodMesh(meshFlat(input, size), input, .1);
}

TEST(Meshes, CombWithThinTeeth) {
  const double size = .05;
  FrontInput input;
  addLoop(input, divided(comb(6, .05, .08, 1), size));
  expectGoodMesh(meshFlat(input, size), input, .1);
}

TEST(Meshes, CombWithTeethThinnerThanTheSize) {
  FrontInput input;
  addLoop(input, divided(comb(4, .02, .1, .5), .06));
  expectGoodMesh(meshFlat(input, .06), input, .02);
}

TEST(Meshes, Star) {
  const double size = .05;
  FrontInput input;
  addLoop(input, divided(star(7, .4, 1), size));
  expectGoodMesh(meshFlat(input, size), input, .1);
}

TEST(Meshes, StarWithSharpPoints) {
  FrontInput input;
  addLoop(input, divided(star(5, .12, 1), .06));
  expectGoodMesh(meshFlat(input, .06), input, .05);
}

TEST(Meshes, TwoRegionsApart) {
  FrontInput input = square(.1);
  addLoop(input, circle({3, 0}, .5, 31));
  expectGoodMesh(meshFlat(input, .1), input, .1);
}

TEST(Meshes, IslandInAHole) {
  const double size = .1;
  FrontInput input;
  addLoop(input, divided({{0, 0}, {3, 0}, {3, 3}, {0, 3}}, size));
  addHole(input, divided({{.8, .8}, {2.2, .8}, {2.2, 2.2}, {.8, 2.2}}, size));
  addLoop(input, circle({1.5, 1.5}, .45, 28));
  expectGoodMesh(meshFlat(input, size), input, .1);
}

TEST(Meshes, HolesThatNearlyTouch) {
  const double size = .1;
  FrontInput input;
  addLoop(input, divided({{0, 0}, {3, 0}, {3, 2}, {0, 2}}, size));
  addLoop(input, circle({1, 1}, .45, 28, true));
  addLoop(input, circle({1.92, 1}, .45, 28, true));
  expectGoodMesh(meshFlat(input, size), input, .05);
}

/// A line inside the region, as a loop that goes there and back.
void addSlit(FrontInput& input, const Points& line) {
  std::vector<BoundaryCorner> loop;
  const std::size_t first = input.vertexCount;
  for (std::size_t i = 0; i < line.size(); ++i) loop.push_back(flatCorner(first + i, line[i]));
  for (std::size_t i = line.size() - 2; i > 0; --i) loop.push_back(loop[i]);
  input.vertexCount += line.size();
  input.loops.push_back(std::move(loop));
}

TEST(Meshes, SlitInside) {
  FrontInput input = square(.1);
  addSlit(input, {{.3, .52}, {.4, .52}, {.5, .52}, {.6, .52}, {.7, .52}});
  expectGoodMesh(meshFlat(input, .1), input, .1);
}

TEST(Meshes, SlitOfOneEdge) {
  FrontInput input = square(.25);
  addSlit(input, {{.4, .5}, {.6, .5}});
  expectGoodMesh(meshFlat(input, .25), input, .05);
}

TEST(Meshes, SlitThatBends) {
  FrontInput input = square(.1);
  addSlit(input, {{.3, .3}, {.4, .3}, {.5, .35}, {.55, .45}, {.55, .55}, {.45, .6}});
  expectGoodMesh(meshFlat(input, .1), input, .1);
}

TEST(Meshes, SlitFromTheBoundary) {
  // One loop whose walk goes in along the line and back out again.
  FrontInput input = square(.25);
  auto& loop = input.loops[0];
  const BoundaryCorner root = loop[2];
  const BoundaryCorner one = flatCorner(input.vertexCount++, {.5, .25});
  const BoundaryCorner two = flatCorner(input.vertexCount++, {.5, .5});
  loop.insert(loop.begin() + 3, {one, two, one, root});
  expectGoodMesh(meshFlat(input, .25), input, .1);
}

TEST(Meshes, RegionsThatTouchInAVertex) {
  FrontInput input;
  addLoop(input, divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, .2));
  const BoundaryCorner shared = input.loops[0][10];
  ASSERT_EQ(shared.point.position, (Point3{1, 1, 0}));
  addLoop(input, divided({{1, 1}, {2, 1}, {2, 2}, {1, 2}}, .2));
  --input.vertexCount;
  for (BoundaryCorner& c : input.loops[1]) --c.vertex.value;
  input.loops[1][0] = shared;
  expectGoodMesh(meshFlat(input, .2), input, .1);
}

TEST(Meshes, HoleThatTouchesTheBoundaryInAVertex) {
  const double size = .1;
  FrontInput input = square(size);
  Points hole = divided({{.5, 0}, {.7, .3}, {.3, .3}}, size);
  std::reverse(hole.begin() + 1, hole.end());
  const std::size_t first = input.vertexCount;
  addLoop(input, hole);
  const BoundaryCorner shared = input.loops[0][5];
  ASSERT_EQ(shared.point.position, (Point3{.5, 0, 0}));
  input.loops[1][0] = shared;
  for (std::size_t i = 1; i < input.loops[1].size(); ++i)
    input.loops[1][i].vertex = VertexId(first + i - 1);
  --input.vertexCount;
  expectGoodMesh(meshFlat(input, size), input, .05);
}

TEST(Meshes, SlitFromTheBoundaryAsALoopOfItsOwn) {
  FrontInput input = square(.25);
  const BoundaryCorner root = input.loops[0][2];
  const BoundaryCorner one = flatCorner(input.vertexCount++, {.5, .25});
  const BoundaryCorner two = flatCorner(input.vertexCount++, {.5, .5});
  input.loops.push_back({root, one, two, one});
  expectGoodMesh(meshFlat(input, .25), input, .1);
}

TEST(Meshes, SlitsThatMeetInAVertex) {
  const double size = .1;
  FrontInput input = square(size);
  const BoundaryCorner middle = flatCorner(input.vertexCount++, {.5, .5});
  for (Point2 d : Points{{size, 0}, {0, size}, {-size, 0}}) {
    const BoundaryCorner end = flatCorner(input.vertexCount++, Point2{.5, .5} + d);
    input.loops.push_back({middle, end});
  }
  expectGoodMesh(meshFlat(input, size), input, .1);
}

TEST(Meshes, IsolatedVertices) {
  FrontInput input = square(.1);
  for (Point2 p : Points{{.5, .5}, {.31, .27}, {.72, .61}, {.2, .8}})
    input.isolated.push_back(flatCorner(input.vertexCount++, p));
  expectGoodMesh(meshFlat(input, .1), input, .05);
}

TEST(Meshes, IsolatedVerticesCloseToEachOtherAndToTheBoundary) {
  FrontInput input = square(.1);
  for (Point2 p : Points{{.5, .5}, {.52, .51}, {.03, .5}, {.5, .97}})
    input.isolated.push_back(flatCorner(input.vertexCount++, p));
  expectGoodMesh(meshFlat(input, .1), input, .01);
}

TEST(Meshes, UnevenBoundary) {
  // Neighbouring edges that differ by a factor of 8.
  FrontInput input;
  Points points;
  const Points corners{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::size_t side = 0; side < 4; ++side) {
    const Point2 p = corners[side], q = corners[(side + 1) % 4];
    double at = 0;
    for (int i = 0; at < .999; ++i) {
      points.push_back(p + at * (q - p));
      at += i % 2 ? .025 : .2;
    }
  }
  addLoop(input, points);
  expectGoodMesh(meshFlat(input, .1), input, .02);
}

TEST(Meshes, OneShortEdgeAmongLongOnes) {
  FrontInput input;
  addLoop(input, {{0, 0}, {.48, 0}, {.52, 0}, {1, 0}, {1, 1}, {0, 1}});
  expectGoodMesh(meshFlat(input, .5), input, .01);
}

TEST(Meshes, GradedSizes) {
  const SizeFunction size(
      [](const Point3& p) { return .01 + .245 * std::sqrt(p.x * p.x + p.y * p.y); });
  const auto side = [&](Point2 p, Point2 q, Points& points) {
    const double total = distance(p, q);
    for (double at = 0; at < total;) {
      const Point2 here = p + (at / total) * (q - p);
      points.push_back(here);
      const double h = size.sizeAt({{here.x, here.y, 0}, {}, 0, 0});
      at = at + 1.5 * h > total ? total : at + h;
    }
  };
  FrontInput input;
  Points points;
  const Points corners{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  for (std::size_t i = 0; i < 4; ++i) side(corners[i], corners[(i + 1) % 4], points);
  addLoop(input, points);
  const MeshingResult result = meshFlat(input, size);
  expectGoodMesh(result, input, .05);
  EXPECT_GT(result.mesh.elements.size(), 100u);
}

TEST(Meshes, TinyCoordinates) {
  const FrontInput input = moved(square(.1), [](Point2 p) { return 1e-9 * p; });
  expectGoodMesh(meshFlat(input, 1e-10), input, .1);
}

TEST(Meshes, HugeCoordinates) {
  const FrontInput input = moved(square(.1), [](Point2 p) { return 1e9 * p; });
  expectGoodMesh(meshFlat(input, 1e8), input, .1);
}

TEST(Meshes, FarFromTheOrigin) {
  const FrontInput input = moved(discWithHole(.05), [](Point2 p) { return p + Point2{1e6, -1e6}; });
  const MeshingResult result = meshFlat(input, .05);
  ASSERT_EQ(result.outcome, Outcome::Complete);
  EXPECT_TRUE(checkMesh(result.mesh, input).empty());
  EXPECT_GE(minQuality(result.mesh), .1);
}

TEST(Meshes, ScaleByAPowerOfTwoWithoutAChange) {
  const FrontInput input = discWithHole(.05);
  const MeshingResult one = meshFlat(input, .05);
  const double s = std::ldexp(1.0, -20);
  const MeshingResult other = meshFlat(moved(input, [&](Point2 p) { return s * p; }), s * .05);
  ASSERT_EQ(one.mesh.elements, other.mesh.elements);
  for (std::size_t i = 0; i < one.mesh.vertices.size(); ++i)
    ASSERT_EQ(s * one.mesh.vertices[i].position, other.mesh.vertices[i].position);
}

TEST(Meshes, ATriangleIsFilledAtOnce) {
  FrontInput input;
  addLoop(input, {{0, 0}, {1, 0}, {.4, .9}});
  const MeshingResult result = meshFlat(input, 1);
  expectGoodMesh(result, input, .5);
  EXPECT_EQ(result.mesh.elements.size(), 1u);
}

TEST(Meshes, NeedlesAreFilled) {
  FrontInput input;
  addLoop(input, {{0, 0}, {5, .1}, {0, .2}});
  expectGoodMesh(meshFlat(input, 1), input, 0);
}

TEST(Meshes, SizesThatDoNotFitTheBoundaryStillGiveAMesh) {
  for (double size : {.02, .05, .3, 1.0, 5.0}) {
    const FrontInput input = square(.1);
    const MeshingResult result = meshFlat(input, size);
    EXPECT_EQ(result.outcome, Outcome::Complete) << size;
    EXPECT_TRUE(checkMesh(result.mesh, input).empty()) << size;
  }
}

TEST(Meshes, OfNothingAreEmpty) {
  const MeshingResult result = meshFlat(FrontInput{}, 1);
  EXPECT_EQ(result.outcome, Outcome::Complete);
  EXPECT_TRUE(result.mesh.elements.empty());
}

}  // namespace
}  // namespace af2
