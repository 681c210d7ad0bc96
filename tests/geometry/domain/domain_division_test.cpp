#include "geometry/domain/domain_division.h"

#include <gtest/gtest.h>

#include "geometry/planar/mesh_planar.h"

namespace af2::geometry {
namespace {

/// To sample an edge everywhere as finely as its finest place asks for would take too much.
TEST(DomainDivision, OfAnEdgeWithOneTinySizeDoesNotTakeMillionsOfSamples) {
  PlanarDomain square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int i = 0; i < 4; ++i) {
    PlanarDomain::Segment& segment = square.segments.emplace_back();
    segment.from = i;
    segment.to = (i + 1) % 4;
    segment.edge = i + 1;
  }
  MeshingOptions options;
  options.sizes.size = 0.5;
  options.sizes.function = [](const Point3& p) {
    if (p.y > 0 || (p.x != 0 && p.x != 0.5)) return 0.5;
    return p.x == 0 ? 5e-5 : 1e-9;
  };
  const DomainModel model = planarModel(square, options);
  const DomainSizes sizes{DomainSize(options.sizes), {0.5}, {}, nullptr, {{nullptr}}};
  const DividedEdges divided = divideCurves(model, sizes, 0.3, {});
  ASSERT_EQ(divided.edges.size(), 4u);
  EXPECT_GT(divided.edges[0].points.size(), 50u);
  EXPECT_LT(divided.edges[0].points.size(), 1000u);
}

}  // namespace
}  // namespace af2::geometry
