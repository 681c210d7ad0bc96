#include "geometry/check/model_check.h"
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/check/element_checker.h"
#include "tests/support/element.h"
#include "tests/support/planar_meshes.h"

namespace af2::geometry {
namespace {

using testing::v;
Element triangle(std::size_t a, std::size_t b, std::size_t c) {
  return {{v(a), v(b), v(c), VertexId()}};
}

/// Two faces of one triangle each, which share the edge 0-1.
ModelMesh roof() {
  ModelMesh mesh;
  mesh.vertices = {{0, 0, 1}, {1, 0, 1}, {0, 1, 0}, {0, -1, 0}};
  mesh.elements = {triangle(0, 1, 2), triangle(1, 0, 3)};
  mesh.face = {1, 2};
  mesh.origins.resize(2);
  mesh.segments = {{v(0), v(1), 1, 2},
                   {v(1), v(2), 2, 1},
                   {v(2), v(0), 3, 1},
                   {v(0), v(3), 4, 1},
                   {v(3), v(1), 5, 1}};
  mesh.faces.resize(2);
  mesh.faces[0].id = 1;
  mesh.faces[1].id = 2;
  return mesh;
}

std::string firstFinding(const ModelMesh& mesh) {
  const auto findings = checkModelMesh(mesh);
  return findings.empty() ? "" : findings.front().what;
}

TEST(ModelCheck, FindsNothingWrongWithASoundMesh) { EXPECT_EQ(firstFinding(roof()), ""); }

TEST(ModelCheck, FindsASegmentThatIsNotUsedAsOftenAsItsFacesRunAlongIt) {
  ModelMesh mesh = roof();
  mesh.segments[0].uses = 1;
  EXPECT_EQ(firstFinding(mesh), "a segment of the boundary is used 2 times, not 1");
}

TEST(ModelCheck, FindsAMissingSegment) {
  ModelMesh mesh = roof();
  mesh.segments.push_back({v(2), v(3), 6, 1});
  EXPECT_EQ(firstFinding(mesh), "a segment of the boundary is missing from the mesh");
}

TEST(ModelCheck, FindsAnOpenEdge) {
  ModelMesh mesh = roof();
  mesh.segments.pop_back();
  EXPECT_EQ(firstFinding(mesh), "an edge has 1 elements, not 2");
}

TEST(ModelCheck, FindsElementsOfOneFaceThatLookTheWrongWay) {
  ModelMesh mesh = roof();
  mesh.face = {1, 1};
  mesh.segments.erase(mesh.segments.begin());
  mesh.elements[1] = triangle(0, 1, 3);
  EXPECT_EQ(firstFinding(mesh), "two elements use an edge in the same direction");
}

TEST(ModelCheck, FindsElementsThatAreNone) {
  ModelMesh mesh = roof();
  mesh.elements[0] = triangle(0, 1, 1);
  EXPECT_EQ(firstFinding(mesh), "an element has a corner twice");
  mesh.elements[0] = triangle(0, 1, 17);
  EXPECT_EQ(firstFinding(mesh), "an element has a corner that is not a vertex");
  mesh = roof();
  mesh.vertices[2] = {0.5, 0, 1};
  EXPECT_EQ(firstFinding(mesh), "an element has no area");
}

TEST(ModelCheck, FindsAnAreaFarFromThatOfTheFace) {
  ModelMesh mesh = roof();
  mesh.faces[0].area = 100;
  EXPECT_NE(firstFinding(mesh).find("times the area of the face"), std::string::npos);
}

TEST(ModelCheck, AFaceMayHaveNoElementsOnlyIfItHasNoArea) {
  ModelMesh mesh = roof();
  mesh.faces.push_back(mesh.faces[0]);
  mesh.faces.back().id = 77;
  for (const double area : {0.0, 1e-9, 0.1}) {
    mesh.faces.back().area = area;
    EXPECT_EQ(checkModelMesh(mesh).empty(), area == 0) << area;
  }
}

TEST(ModelCheck, OfAFaceThatIsThereTwiceTheLaterOneIsAtFault) {
  ModelMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.elements = {triangle(0, 1, 2), triangle(0, 2, 3), triangle(0, 1, 2), triangle(0, 2, 3)};
  mesh.face = {4, 4, 9, 9};
  mesh.origins.resize(4);
  mesh.segments = {{v(0), v(1), 1, 2}, {v(1), v(2), 2, 2}, {v(2), v(3), 3, 2}, {v(3), v(0), 4, 2}};
  const auto findings = checkModelMesh(mesh);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].what, "an edge has 4 elements, not 2");
  EXPECT_EQ(findings[0].face, 9);
}

/// A hexagon of triangles around a vertex inside, which is the first or the last one.
ModelMesh wheel(bool isInsideFirst) {
  ModelMesh mesh;
  mesh.vertices = {{1, 0, 0}, {.5, .8, 0}, {-.5, .8, 0}, {-1, 0, 0}, {-.5, -.8, 0}, {.5, -.8, 0}};
  mesh.vertices.insert(isInsideFirst ? mesh.vertices.begin() : mesh.vertices.end(), Point3{});
  const std::size_t first = isInsideFirst ? 1 : 0, inside = isInsideFirst ? 0 : 6;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t a = first + i, b = first + (i + 1) % 6;
    mesh.elements.push_back(triangle(inside, a, b));
    mesh.segments.push_back({v(a), v(b), 1, 1});
  }
  mesh.face.assign(6, 1);
  mesh.origins.assign(6, {});
  mesh.faces.resize(1);
  mesh.faces[0].id = 1;
  return mesh;
}

TEST(ModelCheck, LooksAtWhatLiesAroundVerticesInsideFaces) {
  for (const bool isInsideFirst : {false, true}) {
    EXPECT_EQ(firstFinding(wheel(isInsideFirst)), "");
    ModelMesh mesh = wheel(isInsideFirst);
    mesh.elements.pop_back();
    mesh.face.pop_back();
    mesh.segments.pop_back();
    EXPECT_EQ(firstFinding(mesh), "an edge has 1 elements, not 2");
    mesh = wheel(isInsideFirst);
    std::swap(mesh.elements[2].corners[0], mesh.elements[2].corners[1]);
    EXPECT_EQ(firstFinding(mesh), "two elements use an edge in the same direction");
    mesh = wheel(isInsideFirst);
    mesh.face[4] = mesh.face[5] = 2;
    EXPECT_EQ(firstFinding(mesh), "an edge that is no model edge has two faces");
    mesh = wheel(isInsideFirst);
    mesh.elements.push_back(mesh.elements[3]);
    mesh.face.push_back(1);
    EXPECT_NE(firstFinding(mesh), "");
  }
}

/// n x n squares of one face, the vertices on its boundary first.
ModelMesh plate(std::size_t n) {
  ModelMesh mesh;
  std::vector<std::size_t> ids((n + 1) * (n + 1));
  const auto place = [&](std::size_t x, std::size_t y) { return y * (n + 1) + x; };
  for (const bool isInside : {false, true})
    for (std::size_t y = 0; y <= n; ++y)
      for (std::size_t x = 0; x <= n; ++x) {
        if ((x > 0 && x < n && y > 0 && y < n) != isInside) continue;
        ids[place(x, y)] = mesh.vertices.size();
        mesh.vertices.push_back({static_cast<double>(x), static_cast<double>(y), 0});
      }
  const auto at = [&](std::size_t x, std::size_t y) { return v(ids[place(x, y)]); };
  for (std::size_t y = 0; y < n; ++y)
    for (std::size_t x = 0; x < n; ++x)
      mesh.elements.push_back({{at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)}});
  mesh.face.assign(mesh.elements.size(), 1);
  mesh.origins.assign(mesh.elements.size(), {});
  for (std::size_t i = 0; i < n; ++i) {
    mesh.segments.push_back({at(i, 0), at(i + 1, 0), 1, 1});
    mesh.segments.push_back({at(i, n), at(i + 1, n), 2, 1});
    mesh.segments.push_back({at(0, i), at(0, i + 1), 3, 1});
    mesh.segments.push_back({at(n, i), at(n, i + 1), 4, 1});
  }
  mesh.faces.resize(1);
  mesh.faces[0].id = 1;
  return mesh;
}

// A large mesh is looked at in parts.
TEST(ModelCheck, FindsTheSameInEachPartOfALargeMesh) {
  constexpr std::size_t kSide = 600, kMiddle = kSide / 2;
  const ModelMesh mesh = plate(kSide);
  EXPECT_EQ(firstFinding(mesh), "");
  for (const std::size_t row : {std::size_t{3}, kMiddle, kSide - 3}) {
    ModelMesh broken = mesh;
    auto& corners = broken.elements[row * kSide + kMiddle].corners;
    std::swap(corners[1], corners[3]);
    const auto findings = checkModelMesh(broken);
    ASSERT_EQ(findings.size(), 4u) << row;
    for (const MeshFinding& finding : findings)
      EXPECT_EQ(finding.what, "two elements use an edge in the same direction");
  }
}

TEST(ModelCheck, StopsAtTheLimit) {
  ModelMesh mesh = roof();
  mesh.segments.clear();
  EXPECT_EQ(checkModelMesh(mesh, 2).size(), 2u);
}

/// A square of n x n squares on one face, with more elements than are looked at together.
ModelMesh largeSquare() {
  constexpr std::size_t kSquares = 300;
  ModelMesh mesh = squareGrid(kSquares);
  const auto addSegment = [&](std::size_t from, std::size_t to) {
    mesh.segments.push_back({v(from), v(to), 1, 1});
  };
  for (std::size_t i = 0; i < kSquares; ++i) {
    const std::size_t row = kSquares + 1;
    addSegment(i, i + 1);
    addSegment(kSquares * row + i, kSquares * row + i + 1);
    addSegment(i * row, (i + 1) * row);
    addSegment(i * row + kSquares, (i + 1) * row + kSquares);
  }
  mesh.faces.resize(1);
  mesh.faces[0].id = 1;
  return mesh;
}

/// The same with the vertices on segments first, as meshes of models have them: then vertices
/// inside are looked at by what surrounds them.
ModelMesh withSegmentsFirst(const ModelMesh& mesh) {
  std::vector<bool> isOnSegment(mesh.vertices.size(), false);
  for (const EdgeSegment& segment : mesh.segments)
    isOnSegment[segment.from.value] = isOnSegment[segment.to.value] = true;
  ModelMesh sorted = mesh;
  std::vector<VertexId> ids(mesh.vertices.size());
  std::size_t next = 0;
  for (const bool first : {true, false})
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      if (isOnSegment[i] == first) {
        sorted.vertices[next] = mesh.vertices[i];
        ids[i] = v(next++);
      }
  for (Element& element : sorted.elements)
    for (VertexId& corner : element.corners)
      if (!corner.isNone()) corner = ids[corner.value];
  for (EdgeSegment& segment : sorted.segments) {
    segment.from = ids[segment.from.value];
    segment.to = ids[segment.to.value];
  }
  return sorted;
}

TEST(ModelCheck, OfALargeMeshFindsTheSameOnAnyNumberOfThreads) {
  for (const ModelMesh& sound : {largeSquare(), withSegmentsFirst(largeSquare())}) {
    EXPECT_EQ(checkModelMesh(sound, 100, 2), std::vector<MeshFinding>());
    for (const std::size_t at : {std::size_t{45'150}, sound.elements.size() - 400}) {
      ModelMesh wrong = sound;
      std::ranges::reverse(wrong.elements[at].corners);
      const std::vector<MeshFinding> findings = checkModelMesh(wrong, 100, 1);
      EXPECT_EQ(findings.size(), 4u);  // its sides
      for (const MeshFinding& finding : findings)
        EXPECT_EQ(finding.what, "two elements use an edge in the same direction");
      EXPECT_EQ(checkModelMesh(wrong, 100, 2), findings);
    }
    ModelMesh holed = sound;
    holed.elements.erase(holed.elements.begin() + 45'150);
    EXPECT_EQ(checkModelMesh(holed, 100, 2).size(), 4u);
  }
}

/// Else all edges are looked at, which takes several times as long.
TEST(ElementChecker, KnowsWhereTheVerticesInsideALargeFaceBegin) {
  const ModelMesh mesh = withSegmentsFirst(largeSquare());
  Findings findings(10);
  ElementChecker elements(mesh, firstInside(mesh), findings);
  elements.checkElements(2);
  ASSERT_TRUE(elements.firstInside().has_value());
  EXPECT_EQ(*elements.firstInside(), mesh.segments.size());
  EXPECT_TRUE(elements.areSurrounded(*elements.firstInside(), 2));
  EXPECT_FALSE(elements.areSurrounded(0, 2));  // vertices on segments are at open edges
  EXPECT_EQ(elements.atSegments().size(), mesh.segments.size() - 4);  // four have two sides there
}

TEST(ModelCheck, OfALargeMeshTellsFindingsInTheOrderOfTheElements) {
  ModelMesh mesh = largeSquare();
  for (const std::size_t e : {80'000u, 10u, 40'000u}) mesh.elements[e].corners[1] = v(1'000'000);
  mesh.elements[50'000].corners[1] = mesh.elements[50'000].corners[0];
  const std::vector<MeshFinding> findings = checkModelMesh(mesh, 4, 2);
  ASSERT_EQ(findings.size(), 4u);
  for (const std::size_t i : {0u, 1u, 3u})
    EXPECT_EQ(findings[i].what, "an element has a corner that is not a vertex");
  EXPECT_EQ(findings[2].what, "an element has a corner twice");
  EXPECT_EQ(checkModelMesh(mesh, 4, 1), findings);
}

}  // namespace
}  // namespace af2::geometry
