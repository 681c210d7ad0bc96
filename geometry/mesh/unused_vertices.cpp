#include "geometry/mesh/unused_vertices.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "geometry/spool/spooled_mesh.h"

namespace af2::geometry {

namespace {

/// Keeps some vertices, and the segments between these. Returns the new ids.
std::vector<VertexId> keepVertices(ModelMesh& mesh, const std::vector<bool>& used) {
  std::vector<VertexId> renumbered(mesh.vertices.size());
  std::size_t count = 0;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    mesh.vertices[count] = mesh.vertices[v];
    if (!mesh.wantedSizes.empty()) mesh.wantedSizes[count] = mesh.wantedSizes[v];
    renumbered[v] = VertexId(count++);
  }
  mesh.vertices.resize(count);
  if (!mesh.wantedSizes.empty()) mesh.wantedSizes.resize(count);
  std::erase_if(mesh.segments,
                [&](const EdgeSegment& s) { return !used[s.from.value] || !used[s.to.value]; });
  for (EdgeSegment& segment : mesh.segments) {
    segment.from = renumbered[segment.from.value];
    segment.to = renumbered[segment.to.value];
  }
  return renumbered;
}

}  // namespace

void dropUnusedVertices(ModelMesh& mesh) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Element& element : mesh.elements) {
    for (const VertexId vertex : element.vertices()) used[vertex.value] = true;
  }
  const std::vector<VertexId> renumbered = keepVertices(mesh, used);
  for (Element& element : mesh.elements) {
    for (VertexId& corner : element.corners) {
      if (!corner.isNone()) corner = renumbered[corner.value];
    }
  }
  for (PeriodicPair& pair : mesh.periodic) {
    std::erase_if(pair.vertices,
                  [&](const auto& v) { return !used[v.first.value] || !used[v.second.value]; });
    for (auto& [second, first] : pair.vertices) {
      second = renumbered[second.value];
      first = renumbered[first.value];
    }
  }
}

void dropSpooledFaces(ModelMesh& mesh, const std::vector<int>& faces) {
  std::vector<SpooledPart> parts = mesh.spooled->parts();
  std::erase_if(
      parts, [&](const SpooledPart& part) { return std::ranges::binary_search(faces, part.face); });
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const SpooledPart& part : parts)
    for (std::size_t v = 0; v < part.boundary.size(); ++v)
      if (part.bulk->counts().isUsed[v]) used[part.boundary[v]] = true;
  const std::vector<VertexId> renumbered = keepVertices(mesh, used);
  for (SpooledPart& part : parts)
    for (std::uint32_t& v : part.boundary)
      if (v < renumbered.size()) v = renumbered[v].value;
  mesh.spooled = std::make_shared<const SpooledMesh>(std::move(parts), mesh.vertices.size(),
                                                     mesh.spooled->file());
}

}  // namespace af2::geometry
