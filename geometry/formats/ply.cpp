// PLY, binary. Vertices and elements only: common readers stumble over further properties of
// elements.
#include "geometry/io/formats.h"

namespace af2::geometry {

void writePly(const ModelMesh& mesh, const Extras&, OutputFile& file) {
  file.text("ply\nformat binary_little_endian 1.0\ncomment surface mesh by AF2\nelement vertex ");
  file.number(cornerVertices(mesh).size());
  file.text("\nproperty double x\nproperty double y\nproperty double z\nelement face ");
  file.number(mesh.elements.size());
  file.text("\nproperty list uchar int vertex_indices\nend_header\n");
  for (const Point3& p : cornerVertices(mesh)) {
    file.binary(p.x);
    file.binary(p.y);
    file.binary(p.z);
  }
  for (const Element& element : mesh.elements) {
    file.binary(static_cast<std::uint8_t>(element.size()));
    for (const VertexId vertex : element.vertices()) file.binary(vertex.value);
  }
}

}  // namespace af2::geometry
