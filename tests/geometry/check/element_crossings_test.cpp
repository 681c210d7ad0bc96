#include "geometry/check/element_crossings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "geometry/check/element_tree.h"
#include "geometry/check/triangle_pair.h"
#include "tests/support/element.h"

namespace af2::geometry {
namespace {

using testing::v;

void lastFirst(std::size_t count, const std::function<void(std::size_t)>& work) {
  for (std::size_t i = count; i-- > 0;) work(i);
}

/// The segments are the edges at which faces end, as in the mesh of a model.
void addSegments(ModelMesh& mesh) {
  std::map<std::pair<VertexId, VertexId>, std::vector<int>> faces;
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    const auto corners = mesh.elements[i].vertices();
    for (std::size_t k = 0; k < corners.size(); ++k)
      faces[std::minmax(corners[k], corners[(k + 1) % corners.size()])].push_back(mesh.face[i]);
  }
  for (const auto& [ends, users] : faces)
    if (users.size() != 2 || users[0] != users[1])
      mesh.segments.push_back({ends.first, ends.second, 1, static_cast<int>(users.size())});
}

/// n x n squares of two triangles each, bent by `place`; face 1 on the left, 2 on the right.
template <class Place>
ModelMesh sheet(std::size_t n, const Place& place) {
  ModelMesh mesh;
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i)
      mesh.vertices.push_back(place(static_cast<double>(i) / static_cast<double>(n),
                                    static_cast<double>(j) / static_cast<double>(n)));
  for (const int face : {1, 2})
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = face == 1 ? 0 : n / 2; i < (face == 1 ? n / 2 : n); ++i) {
        const std::size_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
        mesh.elements.push_back({{v(a), v(b), v(c), VertexId()}});
        mesh.elements.push_back({{v(a), v(c), v(d), VertexId()}});
        mesh.face.insert(mesh.face.end(), 2, face);
      }
  addSegments(mesh);
  return mesh;
}

TEST(ElementCrossings, ThereAreNoneInABentSheet) {
  const ModelMesh mesh = sheet(12, [](double x, double y) {
    return Point3{x, y, std::sin(3 * x) * y};
  });
  EXPECT_TRUE(elementCrossings(mesh, kOneByOne).empty());
}

TEST(ElementCrossings, ThereAreNoneInATubeThatClosesInItself) {
  const ModelMesh mesh = sheet(40, [](double x, double y) {
    return Point3{std::cos(6.2 * x), std::sin(6.2 * x), y};
  });
  EXPECT_TRUE(elementCrossings(mesh, kOneByOne).empty());
}

/// A sheet that is rolled up by more than a turn without growing wider goes through itself.
TEST(ElementCrossings, FindsWhereASheetGoesThroughItself) {
  const ModelMesh mesh = sheet(40, [](double x, double y) {
    const double angle = 8 * x, radius = 1 + 0.3 * y * (x - 0.5);
    return Point3{radius * std::cos(angle), radius * std::sin(angle), y + 0.01 * x};
  });
  EXPECT_FALSE(elementCrossings(mesh, kOneByOne).empty());
}

std::vector<std::array<ElementId, 2>> bruteForce(const ModelMesh& mesh, double depth) {
  std::vector<std::array<ElementId, 2>> pairs;
  const auto corners = [&](std::size_t i) {
    Corners all;
    for (std::size_t k = 0; k < 3; ++k) all[k] = mesh.vertices[mesh.elements[i].corners[k].value];
    return all;
  };
  for (std::size_t i = 0; i < mesh.elements.size(); ++i)
    for (std::size_t k = i + 1; k < mesh.elements.size(); ++k) {
      std::size_t common = 0;
      for (const VertexId a : mesh.elements[i].vertices())
        for (const VertexId b : mesh.elements[k].vertices()) common += a == b;
      if (common < 2 && reachIntoEachOther(corners(i), corners(k), depth))
        pairs.push_back({ElementId(i), ElementId(k)});
    }
  return pairs;
}

/// Those that trying all pairs finds, and these are many.
void expectAllAndMany(const ModelMesh& mesh, double tolerance) {
  std::vector<std::array<ElementId, 2>> found;
  for (const Crossing& crossing : elementCrossings(mesh, kOneByOne))
    if (!crossing.isFold) found.push_back(crossing.elements);
  const auto expected = bruteForce(mesh, tolerance);
  EXPECT_GT(expected.size(), 10u);
  EXPECT_EQ(found, expected);
}

TEST(ElementCrossings, AreThoseThatTryingAllPairsFinds) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-0.06, 0.06);
    const ModelMesh mesh = sheet(14, [&](double x, double y) {
      return Point3{x + shift(random), y + shift(random), shift(random)};
    });
    expectAllAndMany(mesh, 1.5e-9);
  }
}

/// Most of this tube is proven free part by part; what is left must still be found.
TEST(ElementCrossings, OfOnePlaceOfATubeAreFoundAmongMany) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-0.06, 0.06);
  const ModelMesh mesh = sheet(40, [&](double x, double y) {
    const bool isRough = distance(Point3{x, y, 0}, Point3{0.3, 0.5, 0}) < 0.12;
    const double radius = 1 + (isRough ? shift(random) : 0);
    return Point3{radius * std::cos(6 * x), radius * std::sin(6 * x),
                  y + (isRough ? shift(random) : 0)};
  });
  expectAllAndMany(mesh, 2e-9);
}

/// A flat face, and one that comes back down through it and covers a part of its box only.
TEST(ElementCrossings, OfTwoFacesLieWhereTheirBoxesMeet) {
  const ModelMesh mesh = sheet(24, [](double x, double y) {
    if (x <= 0.5) return Point3{x, y, 0};
    const double turn = 9 * (x - 0.5);
    return Point3{0.5 - 0.16 * (1 - std::cos(turn)), y, 0.3 * std::sin(turn) + 0.01 * (y - 0.4)};
  });
  expectAllAndMany(mesh, 2e-9);
}

/// Long strips close to each other, askew in space, whose elements come in turn from both ends.
TEST(ElementTree, BringsFewPairsOfStripsTogether) {
  ModelMesh mesh;
  constexpr std::size_t kSquares = 1000;
  for (const double away : {0.0, 1.0}) {
    const std::size_t first = mesh.vertices.size();
    for (std::size_t i = 0; i <= kSquares; ++i)
      for (const double y : {0.0, 1.0})
        mesh.vertices.push_back(static_cast<double>(i) * unit({1, 1, 1}) + y * unit({1, -1, 0}) +
                                away * unit({1, 1, -2}));
    for (std::size_t n = 0; n < kSquares; ++n) {
      const std::size_t i = first + 2 * (n % 2 == 0 ? n / 2 : kSquares - 1 - n / 2);
      mesh.elements.push_back({{v(i), v(i + 2), v(i + 3), VertexId()}});
      mesh.elements.push_back({{v(i), v(i + 3), v(i + 1), VertexId()}});
    }
  }
  std::vector<std::uint32_t> all(2 * kSquares);
  std::iota(all.begin(), all.end(), 0u);
  const ElementTree one(mesh, 0, all), other(mesh, 2 * kSquares, all);
  std::size_t pairs = 0;
  one.forEachNear(other, 0, [&](const auto&, const auto&) { ++pairs; });
  EXPECT_GT(pairs, 0u);
  EXPECT_LT(pairs, kSquares);  // of 62,500
}

TEST(ElementCrossings, DoNotDependOnTheOrderOfWork) {
  const ModelMesh mesh = sheet(20, [](double x, double y) {
    return Point3{std::cos(9 * x), std::sin(7 * x), y + 0.1 * x};
  });
  EXPECT_EQ(elementCrossings(mesh, kOneByOne), elementCrossings(mesh, lastFirst));
}

/// Two triangles with their corners; in one piece if a third one joins them.
ModelMesh twoThatCross(bool isOnePiece) {
  ModelMesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.7, 0.5, -1}, {0.7, 0.5, 1}, {3, 3, 0}};
  mesh.elements = {{{v(0), v(1), v(2), VertexId()}}, {{v(3), v(4), v(5), VertexId()}}};
  mesh.face = {4, 7};
  if (isOnePiece) {
    mesh.vertices.push_back({3, 0, 0});
    mesh.elements.push_back({{v(1), v(6), v(5), VertexId()}});
    mesh.face.push_back(9);
  }
  addSegments(mesh);
  return mesh;
}

TEST(ElementCrossings, OfPiecesWithoutACommonVertexDoNotCount) {
  EXPECT_TRUE(elementCrossings(twoThatCross(false), kOneByOne).empty());
  const auto crossings = elementCrossings(twoThatCross(true), kOneByOne);
  ASSERT_EQ(crossings.size(), 1u);
  EXPECT_EQ(crossings[0].faces, (std::array{4, 7}));
  EXPECT_FALSE(crossings[0].isFold);
  EXPECT_NEAR(distance(crossings[0].place, {1, 1, 0}), 0, 0.8);
}

TEST(ElementCrossings, AQuadrilateralIsHeldAgainstOthersInHalves) {
  ModelMesh mesh = twoThatCross(true);
  mesh.vertices[2] = {0, 0.4, 0};  // the triangle no longer reaches the other one
  EXPECT_TRUE(elementCrossings(mesh, kOneByOne).empty());
  mesh.vertices.push_back({2, 2, 0});
  mesh.elements[0] = {{v(0), v(1), v(7), v(2)}};
  EXPECT_EQ(elementCrossings(mesh, kOneByOne).size(), 1u);
}

TEST(ElementCrossings, AnElementThatLiesOnItsNeighbourIsAFold) {
  ModelMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0.7, 1e-4}};
  mesh.elements = {{{v(0), v(1), v(2), VertexId()}}, {{v(1), v(0), v(3), VertexId()}}};
  mesh.face = {1, 2};
  addSegments(mesh);
  const auto crossings = elementCrossings(mesh, kOneByOne);
  ASSERT_EQ(crossings.size(), 1u);
  EXPECT_TRUE(crossings[0].isFold);
  mesh.vertices[3] = {0.5, 0.7, 0.1};  // as thin as the edge of a wing
  EXPECT_TRUE(elementCrossings(mesh, kOneByOne).empty());
}

Crossing between(int a, int b) { return {{}, {a, b}, false, {}}; }

TEST(FacesThatCross, TheFaceWithTheMostCrossingsGoesFirst) {
  const auto found = facesThatCross({between(1, 2), between(2, 3), between(2, 4)}, {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].face, 2);
  EXPECT_EQ(found[0].what, "elements cross those of face 1 and 2 more (3 pairs)");
}

TEST(FacesThatCross, OfTwoTheLaterOneGoes) {
  const auto found = facesThatCross({between(5, 8)}, {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].face, 8);
}

TEST(FacesThatCross, AFaceThatCrossesItselfGoes) {
  const auto found = facesThatCross({between(5, 5)}, {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].what, "elements cross each other (1 pair)");
}

TEST(FacesThatCross, WhatHasGoneAlreadyDoesNotCount) {
  EXPECT_TRUE(facesThatCross({between(5, 8)}, {5}).empty());
}

}  // namespace
}  // namespace af2::geometry
