#include "geometry/append_face.h"

namespace af2::geometry {
namespace {

/// Moves `added` to the end of `all`.
template <class T>
void append(std::vector<T>& all, std::vector<T>&& added) {
  if (all.empty()) {
    all = std::move(added);
    return;
  }
  makeRoom(all, added.size());
  all.insert(all.end(), added.begin(), added.end());
  std::vector<T>().swap(added);
}

}  // namespace

void appendFace(ModelMesh& mesh, Mesh meshed, const std::vector<VertexId>& boundary,
                FaceReport& report) {
  const std::size_t base = mesh.vertices.size(), given = boundary.size();
  makeRoom(mesh.vertices, meshed.vertices.size() - given);
  for (std::size_t i = given; i < meshed.vertices.size(); ++i)
    mesh.vertices.push_back(meshed.vertices[i].position);
  std::vector<SurfacePoint>().swap(meshed.vertices);

  report.elements = meshed.elements.size();
  for (Element& element : meshed.elements)
    for (VertexId& v : element.corners)
      if (!v.isNone()) v = v.value < given ? boundary[v.value] : VertexId(base + v.value - given);
  append(mesh.elements, std::move(meshed.elements));
  append(mesh.rule, std::move(meshed.rule));
  makeRoom(mesh.face, report.elements);
  mesh.face.insert(mesh.face.end(), report.elements, report.id);
}

}  // namespace af2::geometry
