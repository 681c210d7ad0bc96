// A mesh of triangles as geometry, for tests.
#pragma once

#include "geometry/faceted/mesh_faceted.h"
#include "tests/support/model_mesh.h"
#include "tests/support/triangle_rules.h"

namespace af2::testing {

/// Held against what must be so of a complete mesh.
inline geometry::ModelMesh completeMesh(const geometry::Facets& facets,
                                        const geometry::MeshingOptions& options) {
  static const AF2Algorithm algorithm(triangleSet());
  geometry::ModelMesh result = geometry::meshFaceted(facets, algorithm, options);
  expectComplete(result);
  EXPECT_EQ(result.wantedSizes.size(), result.vertices.size());
  return result;
}

inline geometry::ModelMesh completeMesh(const geometry::Facets& facets, double size) {
  geometry::MeshingOptions options;
  options.sizes.size = size;
  return completeMesh(facets, options);
}

}  // namespace af2::testing
