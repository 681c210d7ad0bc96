#include "engine/mesh/mesh_check.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/flat_surface.h"

namespace af2 {
namespace {

using namespace af2::testing;
using Kind = MeshFault::Kind;

Element triangle(std::size_t a, std::size_t b, std::size_t c) {
  return {{VertexId(a), VertexId(b), VertexId(c), VertexId()}};
}
Element quad(std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
  return {{VertexId(a), VertexId(b), VertexId(c), VertexId(d)}};
}

/// A square of four triangles around its middle, vertex 4.
struct Square {
  FrontInput input;
  Mesh mesh;

  Square() {
    addLoop(input, {{0, 0}, {2, 0}, {2, 2}, {0, 2}});
    for (const BoundaryCorner& c : input.loops[0]) mesh.vertices.push_back(c.point);
    mesh.vertices.push_back(flatCorner(4, {1, 1}).point);
    for (std::size_t i = 0; i < 4; ++i) mesh.elements.push_back(triangle(i, (i + 1) % 4, 4));
    mesh.origins.assign(4, {});
  }
  std::vector<Kind> faults() const {
    std::vector<Kind> kinds;
    for (const MeshFault& fault : checkMesh(mesh, input)) {
      kinds.push_back(fault.kind);
      EXPECT_FALSE(describe(fault, mesh).empty());
    }
    std::sort(kinds.begin(), kinds.end());
    kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
    return kinds;
  }
};

TEST(MeshCheck, FindsNothingInASoundMesh) { EXPECT_EQ(Square().faults(), std::vector<Kind>{}); }

TEST(MeshCheck, FindsNothingInASoundMeshOfQuadrilaterals) {
  Square s;
  s.mesh.vertices.pop_back();
  s.mesh.elements = {quad(0, 1, 2, 3)};
  EXPECT_EQ(s.faults(), std::vector<Kind>{});
}

TEST(MeshCheck, FindsAnElementThatRepeatsAVertex) {
  Square s;
  s.mesh.elements.push_back(triangle(0, 1, 1));
  EXPECT_EQ(s.faults(), std::vector<Kind>{Kind::BadElement});
}

TEST(MeshCheck, FindsAnElementThatNamesAnUnknownVertex) {
  Square s;
  s.mesh.elements.push_back(triangle(0, 1, 5));
  EXPECT_EQ(s.faults(), std::vector<Kind>{Kind::BadElement});
}

TEST(MeshCheck, FindsAnEdgeUsedTwiceInOneDirection) {
  Square s;
  s.mesh.elements.push_back(s.mesh.elements[0]);
  EXPECT_EQ(s.faults(), std::vector<Kind>{Kind::OverlappingEdge});
}

TEST(MeshCheck, FindsAnEdgeInsideThatIsOpenOnOneSide) {
  Square s;
  s.mesh.vertices.push_back(flatCorner(5, {1, .5}).point);
  s.mesh.elements[0] = triangle(0, 1, 5);
  const auto faults = s.faults();
  EXPECT_EQ(faults, std::vector<Kind>{Kind::OpenEdge});
}

TEST(MeshCheck, FindsABoundaryEdgeWithoutAnElement) {
  Square s;
  s.mesh.elements.erase(s.mesh.elements.begin());
  const auto faults = s.faults();
  EXPECT_TRUE(std::count(faults.begin(), faults.end(), Kind::BoundaryNotKept));
}

TEST(MeshCheck, FindsAnElementBeyondTheBoundary) {
  Square s;
  s.mesh.vertices.push_back(flatCorner(5, {1, -1}).point);
  s.mesh.elements.push_back(triangle(1, 0, 5));
  const auto faults = s.faults();
  EXPECT_TRUE(std::count(faults.begin(), faults.end(), Kind::BoundaryNotKept));
}

TEST(MeshCheck, FindsAnInvertedElement) {
  Square s;
  s.mesh.vertices[4] = flatCorner(4, {3, 1}).point;
  EXPECT_EQ(s.faults(), std::vector<Kind>{Kind::Inverted});
}

TEST(MeshCheck, FindsAFlatElement) {
  Square s;
  s.mesh.vertices[4] = flatCorner(4, {1, 0}).point;
  EXPECT_EQ(s.faults(), std::vector<Kind>{Kind::Inverted});
}

TEST(MeshCheck, FindsAQuadrilateralWithAReflexCorner) {
  Square s;
  s.input.loops[0][2] = flatCorner(2, {.5, .5});
  s.mesh.vertices = {s.mesh.vertices[0], s.mesh.vertices[1], flatCorner(2, {.5, .5}).point,
                     s.mesh.vertices[3]};
  s.mesh.elements = {quad(0, 1, 2, 3)};
  EXPECT_EQ(s.faults(), std::vector<Kind>{Kind::Inverted});
}

TEST(MeshCheck, FindsAQuadrilateralThatTurnsBackWhereNormalsAreUnknown) {
  for (const Point2 place : {Point2{.7, .7}, Point2{1.3, 1.3}}) {
    Square s;
    s.input.loops[0][2] = flatCorner(2, place);
    s.mesh.vertices = {s.mesh.vertices[0], s.mesh.vertices[1], flatCorner(2, place).point,
                       s.mesh.vertices[3]};
    for (SurfacePoint& vertex : s.mesh.vertices) vertex.normal = {};
    s.mesh.elements = {quad(0, 1, 2, 3)};
    const auto expected = place.x < 1 ? std::vector<Kind>{Kind::Inverted} : std::vector<Kind>{};
    EXPECT_EQ(s.faults(), expected);
  }
}

TEST(MeshCheck, FindsAVertexThatIsNotUsed) {
  Square s;
  s.mesh.vertices.push_back(flatCorner(5, {.5, .5}).point);
  EXPECT_EQ(s.faults(), std::vector<Kind>{Kind::UnusedVertex});
}

TEST(MeshCheck, DoesNotHoldElementsAgainstANormalThatIsUndefined) {
  Square s;
  for (SurfacePoint& p : s.mesh.vertices) p.normal = {};
  EXPECT_EQ(s.faults(), std::vector<Kind>{});
}

TEST(MeshCheck, WantsAnElementOnBothSidesOfALineInside) {
  Square s;
  s.input.loops.push_back({flatCorner(0, {0, 0}), flatCorner(4, {1, 1})});
  EXPECT_EQ(s.faults(), std::vector<Kind>{});
  s.input.loops.back() = {flatCorner(4, {1, 1}), flatCorner(5, {1.5, 1})};
  s.mesh.vertices.push_back(flatCorner(5, {1.5, 1}).point);
  const auto faults = s.faults();
  EXPECT_TRUE(std::count(faults.begin(), faults.end(), Kind::BoundaryNotKept));
}

TEST(MeshCheck, DescribesAFaultWithItsPlace) {
  Square s;
  s.mesh.vertices[4] = flatCorner(4, {1, 0}).point;
  const auto faults = checkMesh(s.mesh, s.input);
  ASSERT_FALSE(faults.empty());
  EXPECT_EQ(describe(faults[0], s.mesh),
            "a corner of an element turns against the surface normal, element 0, at (0, 0, 0)");
}

/// n x n squares.
struct Grid {
  FrontInput input;
  Mesh mesh;

  explicit Grid(std::size_t n) {
    const auto at = [&](std::size_t x, std::size_t y) { return y * (n + 1) + x; };
    for (std::size_t y = 0; y <= n; ++y)
      for (std::size_t x = 0; x <= n; ++x)
        mesh.vertices.push_back(
            flatCorner(at(x, y), {static_cast<double>(x), static_cast<double>(y)}).point);
    for (std::size_t y = 0; y < n; ++y)
      for (std::size_t x = 0; x < n; ++x)
        mesh.elements.push_back(quad(at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)));
    mesh.origins.assign(mesh.elements.size(), {});
    input.vertexCount = mesh.vertices.size();
    std::vector<std::size_t> around;
    for (std::size_t i = 0; i < n; ++i) around.push_back(at(i, 0));
    for (std::size_t i = 0; i < n; ++i) around.push_back(at(n, i));
    for (std::size_t i = n; i > 0; --i) around.push_back(at(i, n));
    for (std::size_t i = n; i > 0; --i) around.push_back(at(0, i));
    auto& loop = input.loops.emplace_back();
    for (const std::size_t v : around) loop.push_back({VertexId(v), mesh.vertices[v]});
  }
};

// A large mesh is looked at in parts.
TEST(MeshCheck, FindsTheSameInEachPartOfALargeMesh) {
  constexpr std::size_t kSide = 600, kInside = kSide / 2;
  Grid grid(kSide);
  EXPECT_TRUE(checkMesh(grid.mesh, grid.input).empty());
  for (const std::size_t row : {std::size_t{3}, kSide - 3}) {
    Grid broken = grid;
    broken.mesh.elements.erase(broken.mesh.elements.begin() +
                               static_cast<std::ptrdiff_t>(row * kSide + kInside));
    const auto faults = checkMesh(broken.mesh, broken.input);
    ASSERT_EQ(faults.size(), 4u);
    for (const MeshFault& fault : faults) {
      EXPECT_EQ(fault.kind, Kind::OpenEdge);
      const auto corners = broken.mesh.elements[fault.element.value].vertices();
      EXPECT_NE(std::ranges::find(corners, fault.from), corners.end());
      EXPECT_NE(std::ranges::find(corners, fault.to), corners.end());
    }
  }
  grid.mesh.elements.pop_back();  // in the corner
  std::vector<Kind> kinds;
  for (const MeshFault& fault : checkMesh(grid.mesh, grid.input)) kinds.push_back(fault.kind);
  std::ranges::sort(kinds);
  EXPECT_EQ(kinds, (std::vector<Kind>{Kind::OpenEdge, Kind::OpenEdge, Kind::BoundaryNotKept,
                                      Kind::BoundaryNotKept, Kind::UnusedVertex}));
}

}  // namespace
}  // namespace af2
