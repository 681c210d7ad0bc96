#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "geometry/planar/mesh_planar.h"
#include "tests/geometry/planar/poly_text.h"
#include "tests/support/model_mesh.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

/// Four sides of different lengths around a hole with four sides of different lengths.
const std::string kPlateWithHole =
    "8 2 0 0\n1 0 0\n2 4.9 0\n3 5.6 4.7\n4 0 4\n5 1 1\n6 2.7 1\n7 2.4 2.7\n8 1 3\n"
    "8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n1\n1 2 2\n";
/// A triangle.
const std::string kTriangle = "3 2 0 0\n1 0 0\n2 4 0\n3 0 4\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n";

class EvenLoopsOfDomains : public ::testing::Test {
 protected:
  AF2Algorithm algorithm{testing::triangleSet()};
  MeshingOptions options;

  ModelMesh mesh(const std::string& text, bool evenLoops) {
    options.evenLoops = evenLoops;
    return meshPlanar(testing::polyOf(text), algorithm, options);
  }
  static std::map<int, int> segmentsByEdge(const ModelMesh& mesh) {
    std::map<int, int> segments;
    for (const EdgeSegment& segment : mesh.segments) ++segments[segment.edge];
    return segments;
  }
};

TEST_F(EvenLoopsOfDomains, AreMadeAroundHoles) {
  int oddBefore = 0;
  for (const double size : {0.3, 0.37, 0.45, 0.6, 0.8, 1.1}) {
    SCOPED_TRACE(size);
    options.sizes.size = size;
    const ModelMesh without = mesh(kPlateWithHole, false), even = mesh(kPlateWithHole, true);
    testing::expectComplete(even);
    oddBefore += static_cast<int>(without.faces[0].oddLoops.size());
    EXPECT_EQ(even.faces[0].oddLoops.size(), 0u);
    std::map<int, int> before = segmentsByEdge(without);
    for (const auto& [edge, segments] : segmentsByEdge(even))
      EXPECT_LE(std::abs(segments - before[edge]), 1) << "edge " << edge;
  }
  EXPECT_GT(oddBefore, 0);
}

TEST_F(EvenLoopsOfDomains, StayOddWhereTheBoundaryIsKept) {
  options.sizes.size = 1;
  options.keepBoundary = true;
  const ModelMesh result = mesh(kTriangle, true);
  EXPECT_EQ(result.segments.size(), 3u);
  EXPECT_EQ(result.faces[0].oddLoops.size(), 1u);
  options.keepBoundary = false;
  EXPECT_EQ(mesh(kTriangle, true).faces[0].oddLoops.size(), 0u);
}

TEST_F(EvenLoopsOfDomains, KeepGivenEdges) {
  options.sizes.size = 1;
  options.edgePoints[1] = {{1, 0, 0}, {1.5, 0, 0}};
  const ModelMesh result = mesh(kTriangle, true);
  EXPECT_EQ(segmentsByEdge(result)[1], 3);
  EXPECT_EQ(result.faces[0].oddLoops.size(), 0u);
}

}  // namespace
}  // namespace af2::geometry
