#include "geometry/faceted/half_edges.h"

#include <gtest/gtest.h>

#include <random>

namespace af2::geometry {
namespace {

using Halves = std::vector<HalfEdge>;

/// Laws that hold for any triangles.
void expectLaws(const FacetTriangles& triangles) {
  const HalfEdges sides(triangles);
  const Halves twins = sides.twins();
  ASSERT_EQ(twins.size(), 3 * triangles.size());
  std::vector<int> seen(twins.size(), 0);
  Halves boundary;
  FacetEdge last{0, 0};
  sides.forEachEdge([&](const FacetEdge& edge, std::span<const HalfEdge> halves) {
    EXPECT_LT(edge.first, edge.second);
    EXPECT_LT(last, edge) << "edges come in the order of their vertices, each once";
    last = edge;
    ASSERT_FALSE(halves.empty());
    for (std::size_t i = 0; i < halves.size(); ++i) {
      EXPECT_EQ(edgeOf(triangles, halves[i]), edge);
      EXPECT_TRUE(i == 0 || halves[i - 1] < halves[i]);
      ++seen[halves[i]];
      const HalfEdge twin = halves.size() == 2 ? halves[1 - i] : kNoHalfEdge;
      EXPECT_EQ(twins[halves[i]], twin) << "twins are the two of an edge that has two";
    }
    if (halves.size() == 1) boundary.push_back(halves[0]);
  });
  EXPECT_EQ(seen, std::vector<int>(seen.size(), 1)) << "each half-edge lies on one edge";
  EXPECT_EQ(sides.boundary(), boundary);
}

TEST(HalfEdge, RunsAroundItsTriangle) {
  for (const HalfEdge h : {6u, 7u, 8u}) {
    EXPECT_EQ(nextIn(h) / 3, h / 3);
    EXPECT_EQ(previousIn(nextIn(h)), h);
    EXPECT_EQ(nextIn(nextIn(nextIn(h))), h);
  }
  const FacetTriangles triangles{{5, 3, 4}};
  EXPECT_EQ(startOf(triangles, 1), 3u);
  EXPECT_EQ(endOf(triangles, 2), 5u);
  EXPECT_EQ(edgeOf(triangles, 2), FacetEdge(4, 5));
}

TEST(HalfEdges, OfNoTriangleAreNone) {
  expectLaws({});
  EXPECT_TRUE(HalfEdges({}).twins().empty());
}

TEST(HalfEdges, HaveATwinWhereTwoTrianglesMeet) {
  const FacetTriangles square{{0, 1, 2}, {0, 2, 3}};
  expectLaws(square);
  constexpr HalfEdge o = kNoHalfEdge;
  EXPECT_EQ(HalfEdges(square).twins(), (Halves{o, o, 3, 2, o, o}));
  EXPECT_EQ(HalfEdges(square).boundary(), (Halves{0, 5, 1, 4}));
}

TEST(HalfEdges, HaveATwinAlsoWhereTrianglesAreTurnedAgainstEachOther) {
  const FacetTriangles turned{{0, 1, 2}, {0, 3, 2}};
  expectLaws(turned);
  EXPECT_EQ(HalfEdges(turned).twins()[2], 5u);
}

TEST(HalfEdges, HaveNoTwinWhereSeveralSheetsMeet) {
  const FacetTriangles book{{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};
  expectLaws(book);
  EXPECT_EQ(HalfEdges(book).twins(), Halves(9, kNoHalfEdge));
  EXPECT_EQ(HalfEdges(book).boundary().size(), 6u);
}

TEST(HalfEdges, OfAClosedSurfaceAllHaveTwinsThatRunAgainstThem) {
  const FacetTriangles tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  expectLaws(tetrahedron);
  const Halves twins = HalfEdges(tetrahedron).twins();
  for (HalfEdge h = 0; h < twins.size(); ++h) {
    ASSERT_NE(twins[h], kNoHalfEdge);
    EXPECT_EQ(startOf(tetrahedron, h), endOf(tetrahedron, twins[h]));
  }
}

TEST(HalfEdges, KeepTheirLawsForRandomTriangles) {
  constexpr unsigned kSeed = 7;
  std::mt19937 random(kSeed);
  for (int round = 0; round < 200; ++round) {
    FacetTriangles triangles(random() % 20);
    for (auto& t : triangles) do
        for (auto& v : t) v = random() % 8;
      while (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]);
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", round " + std::to_string(round));
    expectLaws(triangles);
  }
}

}  // namespace
}  // namespace af2::geometry
