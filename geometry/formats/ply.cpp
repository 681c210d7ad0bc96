// PLY, binary. Vertices and elements only: common readers stumble over further properties of
// elements.
#include "geometry/io/formats.h"

namespace af2::geometry {

void writePly(const ModelMesh& mesh, const Extras&, OutputFile& file) {
  file.text("ply\nformat binary_little_endian 1.0\ncomment surface mesh by AF2\nelement vertex ");
  file.number(cornerCount(mesh));
  file.text("\nproperty double x\nproperty double y\nproperty double z\nelement face ");
  file.number(elementCount(mesh));
  file.text("\nproperty list uchar int vertex_indices\nend_header\n");
  forEachCorner(mesh, [&](const Point3& p) {
    file.binary(p.x);
    file.binary(p.y);
    file.binary(p.z);
  });
  forEachElement(mesh, [&](const MeshSlice& slice, std::size_t i) {
    const Element& element = slice.elements[i];
    file.binary(static_cast<std::uint8_t>(element.size()));
    for (const VertexId vertex : element.vertices()) file.binary(vertex.value);
  });
}

}  // namespace af2::geometry
