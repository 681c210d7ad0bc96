#include "geometry/fill/close_front.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace af2::geometry {
namespace {

/// A stuck result whose front is the given loops.
MeshingResult stuckAt(const std::vector<std::vector<Point2>>& loops) {
  MeshingResult result;
  result.outcome = Outcome::Stuck;
  for (const auto& loop : loops) {
    const std::size_t base = result.mesh.vertices.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      result.mesh.vertices.push_back({{loop[i].x, loop[i].y, 0}, {0, 0, 1}});
      result.stuck.push_back(
          {VertexId(base + i), VertexId(base + (i + 1) % loop.size()), 1, {}, {}});
    }
  }
  return result;
}

bool close(MeshingResult& result, std::size_t most = kMaxStuckEdges) {
  const auto vertices = result.mesh.vertices;
  return closeFront(
      result,
      [&](VertexId v) {
        return Point2{vertices[v.value].position.x, vertices[v.value].position.y};
      },
      ElementOrigin{99}, most);
}

double areaOf(const Mesh& mesh) {
  double area = 0;
  for (const Element& e : mesh.elements) {
    const Point3 a = mesh.vertices[e.corners[0].value].position;
    area += cross(mesh.vertices[e.corners[1].value].position - a,
                  mesh.vertices[e.corners[2].value].position - a)
                .z /
            2;
  }
  return area;
}

TEST(CloseFront, FillsAPolygonThatIsNotConvex) {
  MeshingResult result = stuckAt({{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}});
  ASSERT_TRUE(close(result));
  EXPECT_EQ(result.outcome, Outcome::Complete);
  EXPECT_EQ(result.mesh.elements.size(), 3u);
  EXPECT_DOUBLE_EQ(areaOf(result.mesh), 10);
  EXPECT_EQ(result.mesh.origins, std::vector<ElementOrigin>(3, ElementOrigin{99}));
}

TEST(CloseFront, FillsAStripOfThousandsOfSegments) {
  constexpr int kSegments = 1500;
  std::vector<Point2> strip;
  for (int i = 0; i <= kSegments; ++i) strip.push_back({double(i), 0});
  for (int i = kSegments; i >= 0; --i) strip.push_back({double(i), 0.01});
  MeshingResult result = stuckAt({strip});
  EXPECT_FALSE(close(result)) << "so many edges are not merely stuck somewhere";
  ASSERT_TRUE(close(result, kMaxClosingEdges));
  EXPECT_EQ(result.mesh.elements.size(), 2u * kSegments);
  EXPECT_NEAR(areaOf(result.mesh), 0.01 * kSegments, 1e-9);
}

TEST(CloseFront, FindsCornersHoweverFarAway) {
  MeshingResult result = stuckAt({{{0, 0}, {0.001, 0}, {5, 100}}});
  ASSERT_TRUE(close(result));
  EXPECT_EQ(result.mesh.elements.size(), 1u);
  EXPECT_NEAR(areaOf(result.mesh), 0.05, 1e-12);
}

bool isLeft(Point2 a, Point2 b, Point2 c) { return cross(b - a, c - a) > 0; }

/// Whether no side of a polygon without points in line is in a triangle of its corners.
bool isFree(const std::vector<Point2>& polygon, const std::array<std::size_t, 3>& corners) {
  const auto isCorner = [&](std::size_t i) { return std::ranges::count(corners, i) > 0; };
  const auto& [a, b, c] = corners;
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point2 p = polygon[i], q = polygon[(i + 1) % count];
    if (!isCorner(i) && isLeft(polygon[a], polygon[b], p) && isLeft(polygon[b], polygon[c], p) &&
        isLeft(polygon[c], polygon[a], p))
      return false;
    for (const auto& [from, to] : {std::pair(a, c), std::pair(c, b)}) {
      const Point2 s = polygon[from], t = polygon[to];
      const std::size_t next = (i + 1) % count;
      if (i == from || i == to || next == from || next == to) continue;
      if (isLeft(s, t, p) != isLeft(s, t, q) && isLeft(p, q, s) != isLeft(p, q, t)) return false;
    }
  }
  return true;
}

/// The third corner of the first triangle, at the shortest edge: area over squared edges, for all.
std::size_t bestCorner(const std::vector<Point2>& polygon, std::size_t a, std::size_t b) {
  std::size_t best = 0;
  double bestShape = 0;
  for (std::size_t c = 0; c < polygon.size(); ++c) {
    if (c == a || c == b || !isLeft(polygon[a], polygon[b], polygon[c])) continue;
    const Point2 ab = polygon[b] - polygon[a], bc = polygon[c] - polygon[b],
                 ca = polygon[a] - polygon[c];
    const double shape = cross(ab, bc) / (dot(ab, ab) + dot(bc, bc) + dot(ca, ca));
    if (shape <= bestShape || !isFree(polygon, {a, b, c})) continue;
    best = c;
    bestShape = shape;
  }
  return best;
}

TEST(CloseFront, FillsStarsOfLongAndShortEdges) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anyRadius(0.02, 1);
  constexpr int kPoints = 60, kStars = 50;
  for (int star = 0; star < kStars; ++star) {
    std::vector<Point2> points;
    double area = 0;
    for (int i = 0; i < kPoints; ++i) {
      const double angle = 2 * std::numbers::pi * i / kPoints, radius = anyRadius(random);
      points.push_back({3 * radius * std::cos(angle), radius * std::sin(angle)});
    }
    for (int i = 0; i < kPoints; ++i) area += cross(points[i], points[(i + 1) % kPoints]) / 2;
    MeshingResult result = stuckAt({points});
    ASSERT_TRUE(close(result)) << star;
    EXPECT_EQ(result.mesh.elements.size(), kPoints - 2u);
    const auto& corners = result.mesh.elements.front().corners;
    EXPECT_EQ(corners[2].value, bestCorner(points, corners[0].value, corners[1].value)) << star;
    EXPECT_NEAR(areaOf(result.mesh), area, 1e-12);
  }
}

/// Boxes of edges tell little in it: each side has to be compared with many.
TEST(CloseFront, FillsAJaggedRingAtAnAngle) {
  constexpr int kSegments = 700;
  const auto at = [](int i, double radius) {
    const double angle = 2 * std::numbers::pi * i / kSegments;
    const double jagged = radius * (1 + 1e-3 * (i * 37 % 11));
    const Point2 p{100 * jagged * std::cos(angle), jagged * std::sin(angle)};
    return Point2{p.x - p.y, p.x + p.y};
  };
  std::vector<Point2> outer, inner;
  for (int i = 0; i < kSegments; ++i) outer.push_back(at(i, 1));
  for (int i = kSegments; i > 0; --i) inner.push_back(at(i, 0.98));
  const auto areaWithin = [](const std::vector<Point2>& loop) {
    double twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      twice += cross(loop[i], loop[(i + 1) % loop.size()]);
    return twice / 2;
  };
  MeshingResult result = stuckAt({outer, inner});
  ASSERT_TRUE(close(result, kMaxClosingEdges));
  EXPECT_EQ(result.mesh.elements.size(), 2u * kSegments);
  EXPECT_NEAR(areaOf(result.mesh), areaWithin(outer) + areaWithin(inner), 1e-9);
}

TEST(CloseFront, FillsAroundAHole) {
  MeshingResult result =
      stuckAt({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
  ASSERT_TRUE(close(result));
  EXPECT_EQ(result.mesh.elements.size(), 8u);
  EXPECT_DOUBLE_EQ(areaOf(result.mesh), 12);
}

TEST(CloseFront, FillsASliver) {
  MeshingResult result = stuckAt({{{0, 0}, {1, 1e-9}, {2, 0}, {3, 1e-9}, {3, 2e-9}, {1.5, 3e-9}}});
  ASSERT_TRUE(close(result));
  EXPECT_EQ(result.mesh.elements.size(), 4u);
}

/// The square has an edge inside that is on the front from both sides, as a path leaves it.
TEST(CloseFront, FillsOnBothSidesOfAPath) {
  MeshingResult result = stuckAt({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  result.mesh.vertices.push_back({{1, 1, 0}, {0, 0, 1}});
  result.stuck.push_back({VertexId(0), VertexId(4), 1, {}, {}});
  result.stuck.push_back({VertexId(4), VertexId(0), 1, {}, {}});
  ASSERT_TRUE(close(result));
  EXPECT_EQ(result.mesh.elements.size(), 4u);
  EXPECT_DOUBLE_EQ(areaOf(result.mesh), 16);
}

/// Two rings of a tube, on opposite sides of it: what is in front of one plane hides the other.
/// Inside one of them is a ring that is filled around.
TEST(CloseFront, ClosesPartsThatFaceAwayFromEachOther) {
  const std::vector<Point2> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  MeshingResult result = stuckAt({square, square, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
  for (std::size_t v = 0; v < 4; ++v) {
    SurfacePoint& point = result.mesh.vertices[v];
    point.position = {4 - point.position.x, point.position.y, -1};
    point.normal = {0, 0, -1};
  }
  EXPECT_FALSE(close(result)) << "no plane shows all of it";
  ASSERT_TRUE(closeFront(result, ElementOrigin{99}));
  EXPECT_EQ(result.outcome, Outcome::Complete);
  EXPECT_EQ(result.mesh.elements.size(), 2u + 8u);
  EXPECT_DOUBLE_EQ(areaOf(result.mesh), 12 - 16);  // seen from above
}

TEST(CloseFront, LeavesAFrontThatRunsTheWrongWayRoundAlone) {
  MeshingResult result = stuckAt({{{0, 0}, {0, 4}, {4, 4}, {4, 0}}});
  EXPECT_FALSE(close(result));
  EXPECT_EQ(result.outcome, Outcome::Stuck);
  EXPECT_TRUE(result.mesh.elements.empty());
}

TEST(CloseFront, ClosesEachSmallLoopInItsOwnPlane) {
  MeshingResult result = stuckAt({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{6, 0}, {8, 0}, {7, 2}}});
  for (std::size_t v = 0; v < 4; ++v) {  // upright, and not as the normals say
    Point3& p = result.mesh.vertices[v].position;
    p = {p.x, 0, p.y};
  }
  ASSERT_TRUE(closeLoops(result, ElementOrigin{99}));
  EXPECT_EQ(result.outcome, Outcome::Complete);
  EXPECT_EQ(result.mesh.elements.size(), 3u);
  EXPECT_DOUBLE_EQ(areaOf(result.mesh), 2);  // of the loop that lies flat
}

TEST(CloseFront, LeavesLargeLoopsAsTheyAre) {
  std::vector<Point2> circle;
  for (int i = 0; i < 30; ++i) circle.push_back({std::cos(0.2 * i), std::sin(0.2 * i)});
  MeshingResult result = stuckAt({{{6, 0}, {8, 0}, {7, 2}}, circle});
  EXPECT_FALSE(closeLoops(result, ElementOrigin{99}));
  EXPECT_TRUE(result.mesh.elements.empty());
  EXPECT_EQ(result.stuck.size(), 33u);
}

}  // namespace
}  // namespace af2::geometry
