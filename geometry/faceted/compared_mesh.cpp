#include "geometry/faceted/compared_mesh.h"

#include <algorithm>
#include <string>

#include "geometry/faceted/half_edges.h"
#include "geometry/mesh/inside_out.h"
#include "geometry/mesh/quality.h"
#include "geometry/mesh/volume_note.h"

namespace af2::geometry {
namespace {

double volumeOf(const Facets& facets) {
  const Point3 origin = facets.vertices[facets.triangles.front()[0]];
  const auto at = [&](std::uint32_t v) { return facets.vertices[v] - origin; };
  double sum = 0;
  for (const auto& [a, b, c] : facets.triangles) sum += dot(at(a), cross(at(b), at(c)));
  return sum / 6;
}

bool isClosed(const Facets& facets) { return HalfEdges(facets.triangles).boundary().empty(); }

}  // namespace

void compareWithTriangles(const Facets& facets, ModelMesh& mesh) {
  if (std::ranges::any_of(mesh.faces,
                          [](const FaceReport& f) { return f.status != FaceStatus::Complete; }))
    return;
  if (const auto enclosed = enclosedVolume(mesh)) {
    const std::string note = volumeNote(*enclosed, volumeOf(facets), "the triangles of the file");
    if (!note.empty()) mesh.notes.push_back(note);
  } else if (isClosed(facets)) {
    if (const std::size_t open = measureQuality(mesh).freeEdges; open > 0)
      mesh.findings.push_back("the mesh is open, with " + std::to_string(open) +
                              " free edges, but the triangles of the file are closed");
  }
}

}  // namespace af2::geometry
