// Meshing as most tests of models do it: with the classical triangle rules, on one thread.
#pragma once

#include "geometry/occ/run/mesh_model.h"
#include "tests/geometry/occ/shapes.h"
#include "tests/support/triangle_rules.h"

namespace af2::testing {

inline geometry::CadSizes uniform(double size) {
  geometry::CadSizes sizes;
  sizes.size = size;
  return sizes;
}

inline geometry::MeshingOptions ofSize(double size) {
  geometry::MeshingOptions options;
  options.sizes = uniform(size);
  options.threads = 1;
  return options;
}

inline geometry::ModelMesh mesh(const geometry::Model& model,
                                const geometry::MeshingOptions& options) {
  static const AF2Algorithm algorithm(triangleSet());
  return geometry::meshModel(model, algorithm, options);
}

inline geometry::ModelMesh mesh(const geometry::Model& model, double size) {
  return mesh(model, ofSize(size));
}

inline geometry::ModelMesh mesh(const TopoDS_Shape& shape, double size) {
  return mesh(modelOf(shape), size);
}

}  // namespace af2::testing
