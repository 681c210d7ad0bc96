// Wavefront OBJ: text, one group per model face, or the groups that are asked for.
#include <map>
#include <optional>
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
  for (const FaceElements& some : elementsByFace(mesh))
    if (!groups.contains(some.face)) groups[some.face] = inOneWord(msh.nameOf(some.face));
  return groups;
}

}  // namespace

void writeObj(const ModelMesh& mesh, const Extras& extras, OutputFile& file) {
  file.text("# surface mesh by AF2\n");
  forEachCorner(mesh, [&](const Point3& p) {
    file.text("v ");
    file.number(p.x);
    file.text(" ");
    file.number(p.y);
    file.text(" ");
    file.number(p.z);
    file.text("\n");
  });
  const std::map<std::int32_t, std::string> named = groupsOfFaces(mesh, extras);
  std::optional<std::int32_t> last;
  forEachElement(mesh, [&](const MeshSlice& slice, std::size_t i) {
    if (const std::int32_t face = slice.face(i); face != last) {
      last = face;
      const auto name = named.find(face);
      file.text("g ");
      file.text(name == named.end() ? "face_" + std::to_string(face) : name->second);
      file.text("\n");
    }
    file.text("f");
    for (const VertexId vertex : slice.elements[i].vertices()) {
      file.text(" ");
      file.number(vertex.value + 1ull);
    }
    file.text("\n");
  });
}

}  // namespace af2::geometry
