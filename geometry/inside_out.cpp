#include "geometry/inside_out.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace af2::geometry {

namespace {

bool isWhole(const ModelMesh& mesh) {
  const auto isComplete = [](const FaceReport& face) {
    return face.status == FaceStatus::Complete;
  };
  const auto isShared = [](const EdgeSegment& segment) { return segment.uses == 2; };
  return !mesh.elements.empty() && !mesh.segments.empty() && mesh.findings.empty() &&
         std::ranges::all_of(mesh.faces, isComplete) &&
         std::ranges::all_of(mesh.segments, isShared);
}

/// Whether each side between faces is there in both directions. Inside faces that is so anyway.
bool isTurnedAlike(const ModelMesh& mesh) {
  std::vector<bool> isOnEdge(mesh.vertices.size(), false);
  for (const EdgeSegment& segment : mesh.segments)
    isOnEdge[segment.from.value] = isOnEdge[segment.to.value] = true;
  std::vector<std::pair<VertexId, VertexId>> sides, reversed;
  for (const Element& element : mesh.elements) {
    const auto c = element.vertices();
    for (std::size_t i = 0; i < c.size(); ++i) {
      const VertexId from = c[i], to = c[(i + 1) % c.size()];
      if (!isOnEdge[from.value] || !isOnEdge[to.value]) continue;
      sides.emplace_back(from, to);
      reversed.emplace_back(to, from);
    }
  }
  std::ranges::sort(sides);
  std::ranges::sort(reversed);
  return sides == reversed;
}

/// Six times the volume.
double volumeOf(const ModelMesh& mesh) {
  const Point3 origin = mesh.vertices[mesh.elements.front().corners[0].value];
  double sum = 0;
  for (const Element& element : mesh.elements) {
    const auto c = element.vertices();
    const Point3 first = mesh.vertices[c[0].value] - origin;
    for (std::size_t i = 2; i < c.size(); ++i)
      sum += dot(first,
                 cross(mesh.vertices[c[i - 1].value] - origin, mesh.vertices[c[i].value] - origin));
  }
  return sum;
}

}  // namespace

bool isInsideOut(const ModelMesh& mesh) {
  return isWhole(mesh) && isTurnedAlike(mesh) && volumeOf(mesh) < 0;
}

}  // namespace af2::geometry
