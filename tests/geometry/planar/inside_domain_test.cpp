#include "geometry/planar/inside_domain.h"

#include "geometry/planar/mesh_planar.h"
#include "tests/geometry/planar/poly_text.h"
#include "tests/support/model_mesh.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

using Lines = std::vector<std::vector<Point3>>;

const std::string kSquare =
    "4 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n";

ModelMesh meshWith(const std::vector<Point3>& points, const Lines& lines) {
  MeshingOptions options;
  options.sizes.size = 0.4;
  const PlanarDomain domain = withInside(testing::polyOf(kSquare), points, lines);
  const DomainModel model = planarModel(domain, options);
  requireInside(model, points, lines, 1e-9);
  return meshDomain(model, AF2Algorithm(testing::triangleSet()), options);
}

TEST(InsideDomain, PointsAndLinesAreKept) {
  const std::vector<Point3> points{{3.3, 3.1, 0}};
  const ModelMesh mesh =
      meshWith(points, {{{1, 1, 0}, {2, 1, 0}, {2, 3, 0}}, {{0, 3, 0}, {1, 3, 0}}});
  testing::expectComplete(mesh, 16, 1e-9);
  EXPECT_NE(std::ranges::find(mesh.vertices, points[0]), mesh.vertices.end());
  double length = 0;
  for (const EdgeSegment& segment : mesh.segments)
    if (segment.edge > 4)
      length += distance(mesh.vertices[segment.from.value], mesh.vertices[segment.to.value]);
  EXPECT_NEAR(length, 4, 1e-12);
}

TEST(InsideDomain, WhatIsOutsideIsRefused) {
  const auto message = [](const std::vector<Point3>& points, const Lines& lines) {
    return testing::messageOf([&] { meshWith(points, lines); });
  };
  EXPECT_NE(message({{5, 1, 0}}, {}).find("point 1 inside the domain"), std::string::npos);
  EXPECT_NE(message({{1, 1, 1}}, {}).find("z = 0"), std::string::npos);
  EXPECT_NE(message({}, {{{1, 1, 0}}}).find("at least two points"), std::string::npos);
  EXPECT_NE(message({}, {{{1, 1, 0}, {6, 1, 0}}}), "no error");
}

}  // namespace
}  // namespace af2::geometry
