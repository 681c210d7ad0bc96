// Adjacency, and that swaps and collapses keep it.
#include "engine/mesh/mesh_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/meshing.h"
#include "tests/support/quad_grid.h"

namespace af2 {
namespace {

using namespace af2::testing;

/// A hexagon of six triangles around vertex 6; the rim is fixed.
struct Hexagon {
  Mesh mesh;
  FrontInput input;
  Hexagon() {
    addLoop(input, circle({0, 0}, 1, 6));
    for (const BoundaryCorner& c : input.loops[0]) mesh.vertices.push_back(c.point);
    mesh.vertices.push_back({{0, 0, 0}, {0, 0, 1}, 0, 0});
    for (std::size_t i = 0; i < 6; ++i) {
      mesh.elements.push_back({{VertexId(6), VertexId(i), VertexId((i + 1) % 6), VertexId()}});
      mesh.origins.emplace_back();
    }
  }
};

/// Every table entry says what the elements say.
void expectConsistent(const MeshTopology& topology) {
  const Mesh& mesh = topology.mesh();
  std::vector<int> valence(mesh.vertices.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (topology.isDead(e)) continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(mesh.elements[e].size()); ++i) {
      const Corner c(e, i);
      ++valence[topology.vertexAt(c).value];
      const Corner d = topology.across(c);
      if (d.isNone()) continue;
      EXPECT_EQ(topology.across(d), c);
      EXPECT_EQ(topology.vertexAt(d), topology.vertexAt(topology.next(c)));
      EXPECT_EQ(topology.vertexAt(topology.next(d)), topology.vertexAt(c));
    }
  }
  for (std::size_t v = 0; v < valence.size(); ++v) {
    EXPECT_EQ(topology.valence(VertexId(v)), valence[v]);
    const Corner corner = topology.cornerOf(VertexId(v));
    EXPECT_EQ(corner.isNone(), valence[v] == 0);
    if (!corner.isNone()) {
      EXPECT_EQ(topology.vertexAt(corner), VertexId(v));
    }
  }
}

/// The number of elements that a walk around the vertex passes.
int walkLength(const MeshTopology& topology, VertexId v) {
  int count = 0;
  topology.forEachCornerOf(v, [&](Corner) { ++count; });
  return count;
}

TEST(MeshTopology, WalksAroundInnerAndRimVertices) {
  Hexagon hexagon;
  const MeshTopology topology(hexagon.mesh, boundaryOf(hexagon.input));
  expectConsistent(topology);
  EXPECT_EQ(walkLength(topology, VertexId(6)), 6);
  for (std::size_t v = 0; v < 6; ++v) EXPECT_EQ(walkLength(topology, VertexId(v)), 2);
  EXPECT_TRUE(topology.areJoined(VertexId(0), VertexId(1)));
  EXPECT_FALSE(topology.areJoined(VertexId(0), VertexId(2)));
}

TEST(MeshTopology, SwapsASide) {
  Hexagon hexagon;
  MeshTopology topology(hexagon.mesh, boundaryOf(hexagon.input));
  topology.swap({0, 0});  // 6 -> 0 becomes 5 -> 1
  expectConsistent(topology);
  EXPECT_TRUE(topology.areJoined(VertexId(5), VertexId(1)));
  EXPECT_EQ(walkLength(topology, VertexId(6)), 5);
  EXPECT_EQ(walkLength(topology, VertexId(0)), 1);
  EXPECT_TRUE(checkMesh(hexagon.mesh, hexagon.input).empty());
}

TEST(MeshTopology, CollapsesAnInnerVertex) {
  Hexagon hexagon;
  MeshTopology topology(hexagon.mesh, boundaryOf(hexagon.input));
  topology.collapse({0, 0});  // 6 into 0
  expectConsistent(topology);
  topology.compact();
  EXPECT_EQ(hexagon.mesh.elements.size(), 4u);
  EXPECT_EQ(hexagon.mesh.vertices.size(), 6u);
  EXPECT_TRUE(checkMesh(hexagon.mesh, hexagon.input).empty());
}

/// By vertex the corners of all its elements, from the vertex on.
std::vector<std::set<std::vector<std::uint32_t>>> starsOf(const Mesh& mesh) {
  std::vector<std::set<std::vector<std::uint32_t>>> stars(mesh.vertices.size());
  for (const Element& element : mesh.elements) {
    if (element.corners[0].isNone()) continue;
    const auto n = static_cast<std::size_t>(element.size());
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<std::uint32_t> corners;
      for (std::size_t k = 0; k < n; ++k) corners.push_back(element.corners[(i + k) % n].value);
      stars[corners[0]].insert(corners);
    }
  }
  return stars;
}

/// That every vertex that has other elements now is told, once.
template <class Work>
void expectToldOfChanges(MeshTopology& topology, const Work& work) {
  const auto before = starsOf(topology.mesh());
  work();
  const auto after = starsOf(topology.mesh());
  const std::vector<VertexId> told = topology.takeChanged();
  for (std::size_t v = 0; v < before.size(); ++v) {
    if (before[v] == after[v] || after[v].empty()) continue;
    EXPECT_TRUE(std::ranges::find(told, VertexId(v)) != told.end()) << "vertex " << v;
  }
  EXPECT_FALSE(told.empty());
  EXPECT_TRUE(topology.takeChanged().empty());
}

TEST(MeshTopology, TellsWhichVerticesHaveOtherElements) {
  {
    Hexagon hexagon;
    MeshTopology topology(hexagon.mesh, boundaryOf(hexagon.input));
    EXPECT_TRUE(topology.takeChanged().empty());
    expectToldOfChanges(topology, [&] { topology.swap({0, 0}); });
  }
  {
    Hexagon hexagon;
    MeshTopology topology(hexagon.mesh, boundaryOf(hexagon.input));
    expectToldOfChanges(topology, [&] { topology.collapse({0, 0}); });
  }
  QuadGrid grid(3);
  const auto [a, b, c, d] = grid.element(1, 1).corners;
  MeshTopology topology(grid.mesh, boundaryOf(grid.input));
  expectToldOfChanges(topology, [&] {
    topology.replace({4}, std::vector<Element>{{{a, b, c, {}}}, {{a, c, d, {}}}});
  });
  expectToldOfChanges(topology, [&] {
    topology.replace({4, 9}, std::vector<Element>{{{a, b, c, d}}});
  });
}

/// Gives each element a grade, and returns the elements that have none after some work.
template <class Work>
std::set<std::size_t> ungradedAfter(MeshTopology& topology, const Work& work) {
  for (std::size_t e = 0; e < topology.mesh().elements.size(); ++e) topology.setGrade(e, 7);
  work();
  std::set<std::size_t> found;
  for (std::size_t e = 0; e < topology.mesh().elements.size(); ++e)
    if (topology.gradeOf(e) == 0) found.insert(e);
  return found;
}

TEST(MeshTopology, ForgetsGradesOfElementsThatChange) {
  {
    Hexagon hexagon;
    MeshTopology topology(hexagon.mesh, boundaryOf(hexagon.input));
    const std::set<std::size_t> both{topology.across({0, 0}).element(), 0};
    EXPECT_EQ(ungradedAfter(topology, [&] { topology.swap({0, 0}); }), both);
    EXPECT_EQ(ungradedAfter(topology, [&] { topology.move(VertexId(6), hexagon.mesh.vertices[6]); })
                  .size(),
              5u);
  }
  {
    Hexagon hexagon;
    MeshTopology topology(hexagon.mesh, boundaryOf(hexagon.input));
    const auto ungraded = ungradedAfter(topology, [&] { topology.collapse({0, 0}); });
    for (std::size_t e = 0; e < 6; ++e)
      EXPECT_TRUE(topology.isDead(e) || ungraded.contains(e)) << e;
  }
  QuadGrid grid(3);
  const auto [a, b, c, d] = grid.element(1, 1).corners;
  MeshTopology topology(grid.mesh, boundaryOf(grid.input));
  EXPECT_EQ(
      ungradedAfter(topology,
                    [&] {
                      topology.replace({4}, std::vector<Element>{{{a, b, c, {}}}, {{a, c, d, {}}}});
                    }),
      (std::set<std::size_t>{4, 9}));
}

TEST(MeshTopology, IsCutAlongLinesInsideTheRegion) {
  // A square with one diagonal that must stay: 0 -> 2 and 2 -> 0 are boundary edges.
  Mesh mesh;
  FrontInput input;
  addLoop(input, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (const BoundaryCorner& c : input.loops[0]) mesh.vertices.push_back(c.point);
  input.loops.push_back({input.loops[0][0], input.loops[0][2]});
  for (auto corners : {std::array{0u, 1u, 2u}, std::array{0u, 2u, 3u}})
    mesh.elements.push_back(
        {{VertexId(corners[0]), VertexId(corners[1]), VertexId(corners[2]), VertexId()}});
  mesh.origins.resize(2);
  const MeshTopology topology(mesh, boundaryOf(input));
  for (std::size_t e = 0; e < 2; ++e)
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(topology.across({e, i}).isNone());
}

TEST(MeshTopology, StaysConsistentWhenElementsAreReplaced) {
  QuadGrid grid(3);
  const auto [a, b, c, d] = grid.element(1, 1).corners;
  MeshTopology topology(grid.mesh, boundaryOf(grid.input));
  topology.replace({4}, std::vector<Element>{{{a, b, c, {}}}, {{a, c, d, {}}}});
  expectConsistent(topology);
  EXPECT_EQ(grid.mesh.elements.size(), 10u);
  EXPECT_EQ(walkLength(topology, a), 5);
  topology.replace({4, 9}, std::vector<Element>{{{a, b, c, d}}});
  expectConsistent(topology);
  EXPECT_TRUE(topology.isDead(9));
  // Those at the rim, too: a vertex of a side of two elements goes into the other.
  const VertexId e = grid.id(0, 1);
  EXPECT_EQ(topology.vertexAt(Corner(0, 3)), e);
  topology.replace({0, 3}, std::vector<Element>{{{grid.id(0, 0), grid.id(1, 0), grid.id(1, 1), e}},
                                                {{e, a, grid.id(1, 2), grid.id(0, 2)}}});
  expectConsistent(topology);
  EXPECT_EQ(walkLength(topology, e), 2);
  topology.compact();
  EXPECT_TRUE(checkMesh(grid.mesh, grid.input).empty());
}

}  // namespace
}  // namespace af2
