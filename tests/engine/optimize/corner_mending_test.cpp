// That the worst corners of quadrilaterals get better, and nothing else worse.
#include "engine/optimize/corner_mending.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "engine/mesh/element_measures.h"
#include "tests/support/flat_surface.h"
#include "tests/support/meshing.h"

namespace af2 {
namespace {

using namespace af2::testing;

/// Two by two quadrilaterals on a rectangle of width 2 and this height; the inner vertex, which is
/// the last one, lies at (x, y).
struct FourQuads {
  FrontInput input;
  Mesh mesh;

  FourQuads(double height, double x, double y) {
    addLoop(input, std::vector<Point2>{{0, 0},
                                       {1, 0},
                                       {2, 0},
                                       {2, height / 2},
                                       {2, height},
                                       {1, height},
                                       {0, height},
                                       {0, height / 2}});
    for (const BoundaryCorner& c : input.loops[0]) mesh.vertices.push_back(c.point);
    mesh.vertices.push_back(SurfacePoint{{x, y, 0}, {0, 0, 1}});
    for (std::size_t corner : {0, 2, 4, 6}) {
      Element element;
      const std::size_t ring[]{corner, corner + 1, 8, (corner + 7) % 8};
      std::ranges::transform(ring, element.corners.begin(),
                             [](std::size_t v) { return VertexId(v); });
      mesh.elements.push_back(element);
      mesh.origins.emplace_back();
    }
  }

  std::size_t mend() {
    MeshTopology topology(mesh, boundaryOf(input));
    return mendCorners(topology, mesh, FlatMaker(), nullptr, {});
  }

  double leastJacobian() const {
    double least = 1;
    for (const Element& element : mesh.elements) {
      std::vector<Point2> corners;
      for (const VertexId v : element.vertices()) {
        const Point3& p = mesh.vertices[v.value].position;
        corners.push_back({p.x, p.y});
      }
      least = std::min(least, scaledJacobian(corners));
    }
    return least;
  }
};

TEST(CornerMending, MovesAVertexToWhereTheWorstCornerIsBest) {
  FourQuads mesh(2, 1.4, 1.3);
  const Mesh before = mesh.mesh;
  EXPECT_LT(mesh.leastJacobian(), 0.8);
  EXPECT_GT(mesh.mend(), 0u);
  EXPECT_GE(mesh.leastJacobian(), 0.9);
  for (std::size_t v = 0; v < 8; ++v)
    EXPECT_EQ(mesh.mesh.vertices[v].position, before.vertices[v].position);
}

TEST(CornerMending, LeavesGoodQuadrilateralsAlone) {
  FourQuads mesh(2, 1.05, 1.1);
  EXPECT_EQ(mesh.mend(), 0u);
}

/// The largest ratio of the two sides of a corner.
double largestRatio(const Mesh& mesh) {
  double largest = 1;
  for (const Element& element : mesh.elements)
    for (std::size_t i = 0; i < 4; ++i) {
      const auto at = [&](std::size_t k) {
        return mesh.vertices[element.corners[k % 4].value].position;
      };
      const double ahead = distance(at(i), at(i + 1)), behind = distance(at(i), at(i + 3));
      largest = std::max({largest, ahead / behind, behind / ahead});
    }
  return largest;
}

TEST(CornerMending, DoesNotMakeSidesMoreUnevenThanTwoToOneOrThanTheyWere) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-0.55, 0.55);
  int mended = 0;
  for (int i = 0; i < 300; ++i) {
    FourQuads mesh(2, 1 + off(random), 1 + off(random));
    for (std::size_t v = 1; v < 8; v += 2) {  // the middles of the sides, along them
      Point3& place = mesh.mesh.vertices[v].position;
      (v % 4 == 1 ? place.x : place.y) += off(random);
    }
    const double before = largestRatio(mesh.mesh), least = mesh.leastJacobian();
    mended += mesh.mend() > 0;
    EXPECT_LE(largestRatio(mesh.mesh), std::max(2.0, before) + 1e-9) << i;
    EXPECT_GE(mesh.leastJacobian(), least) << i;
  }
  EXPECT_GT(mended, 100);
}

TEST(CornerMending, StopsWhenAsked) {
  FourQuads mesh(2, 1.4, 1.3);
  MeshTopology topology(mesh.mesh, boundaryOf(mesh.input));
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(mendCorners(topology, mesh.mesh, FlatMaker(), nullptr, source.get_token()), 0u);
}

}  // namespace
}  // namespace af2
