// What tests ask of a mesh of a whole model.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "geometry/check/element_crossings.h"
#include "geometry/check/model_check.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::testing {

/// Of all faces, or of the one with that number.
inline double areaOf(const geometry::ModelMesh& mesh, int face = 0) {
  double area = 0;
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    if (face > 0 && mesh.face[i] != face) continue;
    const auto at = [&](std::size_t k) { return mesh.vertices[mesh.elements[i].corners[k].value]; };
    area += length(cross(at(1) - at(0), at(2) - at(0))) / 2;
  }
  return area;
}

/// Of all corners of triangles, in degrees.
inline double leastAngle(const geometry::ModelMesh& mesh) {
  double least = std::numbers::pi;
  for (const Element& e : mesh.elements) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](std::size_t k) { return mesh.vertices[e.corners[(i + k) % 3].value]; };
      const Point3 p = at(1) - at(0), q = at(2) - at(0);
      least = std::min(least, std::atan2(length(cross(p, q)), dot(p, q)));
    }
  }
  return least * 180 / std::numbers::pi;
}

/// Positive if the elements look outwards. Only a closed mesh has one that does not depend on where
/// the origin is.
inline double volumeOf(const geometry::ModelMesh& mesh, const Point3& origin = {}) {
  double volume = 0;
  for (const Element& e : mesh.elements) {
    const auto at = [&](std::size_t i) { return mesh.vertices[e.corners[i].value] - origin; };
    volume += dot(at(0), cross(at(1), at(2))) / 6;
  }
  return volume;
}

/// V - E + F, if each edge has two triangles; else a number that no surface has.
inline int eulerNumber(const geometry::ModelMesh& mesh) {
  std::map<std::pair<VertexId, VertexId>, int> edges;
  for (const Element& e : mesh.elements)
    for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(e.corners[i], e.corners[(i + 1) % 3])];
  for (const auto& [edge, uses] : edges)
    if (uses != 2) return -1000;
  return static_cast<int>(mesh.vertices.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(mesh.elements.size());
}

/// How many places there are at which elements cross or fold.
inline std::size_t crossingsOf(const geometry::ModelMesh& mesh) {
  return elementCrossings(mesh, geometry::kOneByOne).size();
}

/// Every face complete, all checks passed.
inline void expectComplete(const geometry::ModelMesh& mesh) {
  for (const geometry::FaceReport& face : mesh.faces)
    EXPECT_EQ(face.status, geometry::FaceStatus::Complete)
        << "face " << face.id << ": " << face.reason;
  EXPECT_TRUE(mesh.findings.empty());
  for (const auto& finding : checkModelMesh(mesh)) ADD_FAILURE() << finding.what;
}

/// The same, and of about the right area.
inline void expectComplete(const geometry::ModelMesh& mesh, double area, double tolerance = 0.05) {
  expectComplete(mesh);
  EXPECT_NEAR(areaOf(mesh), area, tolerance * area);
}

}  // namespace af2::testing
