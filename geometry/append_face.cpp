#include "geometry/append_face.h"

namespace af2::geometry {

void appendFace(ModelMesh& mesh, const MeshingResult& result, const std::vector<VertexId>& boundary,
                FaceReport& report) {
  const std::size_t base = mesh.vertices.size();
  for (std::size_t i = boundary.size(); i < result.mesh.vertices.size(); ++i)
    mesh.vertices.push_back(result.mesh.vertices[i].position);
  for (Element element : result.mesh.elements) {
    for (VertexId& v : element.corners)
      if (!v.isNone())
        v = v.value < boundary.size() ? boundary[v.value]
                                      : VertexId(base + v.value - boundary.size());
    mesh.elements.push_back(element);
    mesh.face.push_back(report.id);
  }
  mesh.rule.insert(mesh.rule.end(), result.mesh.rule.begin(), result.mesh.rule.end());
  report.elements = result.mesh.elements.size();
}

}  // namespace af2::geometry
