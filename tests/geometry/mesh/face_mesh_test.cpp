#include "geometry/mesh/face_mesh.h"

#include <gtest/gtest.h>

#include "geometry/mesh/join_faces.h"

namespace af2::geometry {
namespace {

/// A ribbon of two triangles between the segments of two edges that lie `apart`.
struct Ribbon {
  explicit Ribbon(double apart) {
    divided.points = {{0, 0, 0}, {1, 0, 0}, {0, apart, 0}, {1, apart, 0}};
    for (const std::uint32_t first : {0u, 2u}) {
      divided.edges.emplace_back().points = {first, first + 1};
      mesh.uses.push_back({static_cast<int>(divided.edges.size()), 0});
    }
    mesh.boundary = {0, 1, 2, 3};
    mesh.wantedSizes.assign(4, 0.1);  // the segments are longer than what is wanted
    const auto id = [](std::size_t v) { return VertexId(v); };
    mesh.elements = {{{id(0), id(1), id(3), {}}}, {{id(0), id(3), id(2), {}}}};
  }
  DividedEdges divided;
  FaceMesh mesh;
};

TEST(FaceMesh, TellsWhetherElementsReachMuchFartherThanTheirSegments) {
  const Ribbon near(4), far(20);
  EXPECT_FALSE(reachesTooFar(near.mesh, near.divided));
  EXPECT_TRUE(reachesTooFar(far.mesh, far.divided));
  Ribbon few(20);  // two of a hundred
  few.mesh.elements.resize(100, {{VertexId(0), VertexId(1), VertexId(1), {}}});
  EXPECT_FALSE(reachesTooFar(few.mesh, few.divided));
}

TEST(JoinFaces, GivesSegmentsThatNoElementKeptTheirVertices) {
  Ribbon lost(1);
  lost.mesh.elements.resize(1);  // without the vertex 2
  lost.mesh.origins.resize(1);
  const ModelMesh joined = joinFaces(lost.divided, {lost.mesh}, {});
  ASSERT_EQ(joined.segments.size(), 2u);
  for (const EdgeSegment& segment : joined.segments)
    for (const VertexId v : {segment.from, segment.to}) EXPECT_LT(v.value, joined.vertices.size());
}

TEST(JoinFaces, KeepsWhatIsKnownOfVerticesInside) {
  Ribbon with(1);
  with.mesh.inside = {{0.5, 0.4, 0}, {0.5, 0.6, 0}};
  with.mesh.wantedSizes = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  with.mesh.elements.push_back({{VertexId(0), VertexId(4), VertexId(5), {}}});
  with.mesh.origins.resize(3);
  with.mesh.origins.back().rule = 7;
  with.mesh.report.id = 3;
  const ModelMesh joined = joinFaces(with.divided, {with.mesh}, {});
  ASSERT_EQ(joined.vertices.size(), 6u);
  EXPECT_EQ(joined.vertices[4], (Point3{0.5, 0.4, 0}));
  EXPECT_EQ(joined.vertices[5], (Point3{0.5, 0.6, 0}));
  EXPECT_EQ(joined.wantedSizes, with.mesh.wantedSizes);
  EXPECT_EQ(joined.elements.back(), with.mesh.elements.back());
  EXPECT_EQ(joined.origins.back().rule, 7);
  EXPECT_EQ(joined.face, (std::vector<std::int32_t>{3, 3, 3}));
}

}  // namespace
}  // namespace af2::geometry
