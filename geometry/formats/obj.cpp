// Wavefront OBJ: text, one group per model face, or the groups that are asked for.
#include <map>
#include <string>

#include "geometry/formats/msh_groups.h"
#include "geometry/io/formats.h"

namespace af2::geometry {
namespace {

/// Names of groups end at blanks.
std::string inOneWord(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= ' ') c = '_';
  return name;
}

/// By face: its group, if there are groups.
std::map<std::int32_t, std::string> groupsOfFaces(const ModelMesh& mesh, const Extras& extras) {
  std::map<std::int32_t, std::string> groups;
  if (extras.groups.empty()) return groups;
  const MshGroups msh(mesh, {{}, extras.groups}, {});
  for (const std::int32_t face : mesh.face)
    if (!groups.contains(face)) groups[face] = inOneWord(msh.nameOf(face));
  return groups;
}

}  // namespace

void writeObj(const ModelMesh& mesh, const Extras& extras, OutputFile& file) {
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
  const std::map<std::int32_t, std::string> named = groupsOfFaces(mesh, extras);
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    if (i == 0 || mesh.face[i] != mesh.face[i - 1]) {
      const auto name = named.find(mesh.face[i]);
      file.text("g ");
      file.text(name == named.end() ? "face_" + std::to_string(mesh.face[i]) : name->second);
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
