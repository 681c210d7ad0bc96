#include "engine/mesh_check.h"

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
    mesh.rule.assign(4, 0);
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
            "an element is turned against the surface, element 0, at (0, 0, 0)");
}

}  // namespace
}  // namespace af2
