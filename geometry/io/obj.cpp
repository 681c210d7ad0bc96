// Wavefront OBJ: text, one group per model face.
#include "geometry/io/formats.h"

namespace af2::geometry {

void writeObj(const ModelMesh& mesh, const Extras&, OutputFile& file) {
  file.text("# surface mesh by AF2\n");
  for (const Point3& p : cornerVertices(mesh)) {
    file.text("v ");
    file.number(p.x);
    file.text(" ");
    file.number(p.y);
    file.text(" ");
    file.number(p.z);
    file.text("\n");
  }
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    if (i == 0 || mesh.face[i] != mesh.face[i - 1]) {
      file.text("g face_");
      file.number(mesh.face[i]);
      file.text("\n");
    }
    file.text("f");
    for (const VertexId vertex : mesh.elements[i].vertices()) {
      file.text(" ");
      file.number(vertex.value + 1ull);
    }
    file.text("\n");
  }
}

}  // namespace af2::geometry
