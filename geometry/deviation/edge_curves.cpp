#include "geometry/deviation/edge_curves.h"

namespace af2::geometry {

EdgeCurves edgeCurves(const ModelMesh& mesh, const DividedEdges& divided,
                      const std::function<Point3(int edge, double parameter)>& pointOnEdge) {
  constexpr int kParts = 8;  // of a segment
  EdgeCurves curves(mesh.segments.size());
  int edge = 0;
  std::size_t k = 0;  // segment of the edge
  for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
    const EdgeSegment& segment = mesh.segments[s];
    if (segment.edge != edge) {
      edge = segment.edge;
      k = 0;
    }
    const DividedEdge& along = divided.edges[static_cast<std::size_t>(edge) - 1];
    const Point3 &from = mesh.vertices[segment.from.value], &to = mesh.vertices[segment.to.value];
    // Segments that no face uses are not in the mesh.
    while (k + 1 < along.points.size() &&
           !(divided.points[along.points[k]] == from && divided.points[along.points[k + 1]] == to))
      ++k;
    if (k + 1 >= along.points.size()) continue;
    const double first = along.parameters[k], last = along.parameters[k + 1];
    for (int i = 1; i < kParts; ++i)
      curves[s].push_back(pointOnEdge(edge, first + (last - first) * i / kParts));
    ++k;
  }
  return curves;
}

}  // namespace af2::geometry
