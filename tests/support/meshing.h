// Running the engine on a flat region and holding the result against what it should be.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/mesh/mesh_check.h"
#include "engine/run/algorithm.h"
#include "tests/support/flat_surface.h"
#include "tests/support/triangle_rules.h"

namespace af2::testing {

/// 4 sqrt(3) area / sum of squared edges: 1 for the equilateral triangle.
inline double triangleQuality(const Mesh& mesh, const Element& element) {
  const auto at = [&](std::size_t i) { return mesh.vertices[element.corners[i].value].position; };
  const Point3 p = at(1) - at(0), q = at(2) - at(0), r = at(2) - at(1);
  return 2 * std::sqrt(3.0) * length(cross(p, q)) / (dot(p, p) + dot(q, q) + dot(r, r));
}

inline double minQuality(const Mesh& mesh) {
  double least = 1;
  for (const Element& e : mesh.elements)
    if (!e.isQuad()) least = std::min(least, triangleQuality(mesh, e));
  return least;
}

/// Coordinates are taken relative to the first vertex, so that regions far out lose no digits.
inline double areaOf(const Mesh& mesh) {
  double area = 0;
  for (const Element& e : mesh.elements) {
    const Point3 origin = mesh.vertices[e.corners[0].value].position;
    for (int i = 1; i + 1 < e.size(); ++i) {
      const auto at = [&](int k) {
        return mesh.vertices[e.corners[static_cast<std::size_t>(k)].value].position - origin;
      };
      area += 0.5 * cross(at(i), at(i + 1)).z;
    }
  }
  return area;
}

inline double areaOf(const FrontInput& input) {
  double area = 0;
  if (input.loops.empty()) return area;
  const Point3 origin = input.loops[0][0].point.position;
  for (const auto& loop : input.loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      area += 0.5 * cross(loop[i].point.position - origin,
                          loop[(i + 1) % loop.size()].point.position - origin)
                        .z;
  return area;
}

/// Complete, without faults, of the right area, with its boundary, no triangle worse than asked.
inline void expectGoodMesh(const MeshingResult& result, const FrontInput& input,
                           double leastQuality) {
  ASSERT_EQ(result.outcome, Outcome::Complete);
  EXPECT_TRUE(result.stuck.empty());
  EXPECT_TRUE(result.unused.empty());
  const auto faults = checkMesh(result.mesh, input);
  for (std::size_t i = 0; i < std::min<std::size_t>(faults.size(), 5); ++i)
    ADD_FAILURE() << describe(faults[i], result.mesh);
  EXPECT_EQ(faults.size(), 0u);
  const double area = areaOf(input);
  EXPECT_NEAR(areaOf(result.mesh), area, 1e-9 * std::abs(area));
  EXPECT_EQ(result.mesh.origins.size(), result.mesh.elements.size());
  for (const auto& loop : input.loops)
    for (const BoundaryCorner& corner : loop)
      EXPECT_EQ(result.mesh.vertices[corner.vertex.value], corner.point);
  EXPECT_GE(minQuality(result.mesh), leastQuality);
}

inline MeshingResult meshFlat(const FrontInput& input, const SizeField& size) {
  return AF2Algorithm(triangleSet()).execute(FlatMaker(), input, size);
}
inline MeshingResult meshFlat(const FrontInput& input, double size) {
  return meshFlat(input, UniformSize(size));
}

/// Everything that a result says, to be compared as a whole.
inline void expectEqualResults(const MeshingResult& one, const MeshingResult& other) {
  EXPECT_EQ(one.outcome, other.outcome);
  EXPECT_EQ(one.steps, other.steps);
  EXPECT_EQ(one.failedSteps, other.failedSteps);
  EXPECT_EQ(one.unused, other.unused);
  EXPECT_EQ(one.stuck.size(), other.stuck.size());
  EXPECT_EQ(one.mesh.elements.size(), other.mesh.elements.size());
  EXPECT_TRUE(one.mesh == other.mesh) << "the meshes differ";
}

}  // namespace af2::testing
