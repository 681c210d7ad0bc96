// Mesh files as surfaces to be meshed: faces of the mesh are parts, and other polygons than
// triangles are split.
#include <algorithm>
#include <map>
#include <string>

#include "geometry/faceted/formats.h"
#include "geometry/mesh/triangles_of.h"
#include "geometry/reading/formats.h"

namespace af2::geometry {
namespace {

/// AF2 and others call a face so that has no name.
bool isNumberOnly(const std::string& name) {
  constexpr std::string_view kFace = "face ";
  return name.starts_with(kFace) &&
         name.find_first_not_of("0123456789", kFace.size()) == std::string::npos;
}

void addFacets(MeshFile file, Facets& facets) {
  std::map<std::int32_t, std::uint32_t> partOf;  // by face
  for (const FaceReport& face : file.mesh.faces) {
    partOf[face.id] = static_cast<std::uint32_t>(facets.groupNames.size());
    facets.groupNames.push_back(isNumberOnly(face.name) ? "" : face.name);
  }
  for (std::size_t e = 0; e < file.mesh.elements.size(); ++e)
    for (const auto& [a, b, c] : trianglesOf(file.mesh, file.mesh.elements[e])) {
      facets.triangles.push_back({a.value, b.value, c.value});
      facets.group.push_back(partOf.at(file.mesh.face[e]));
    }
  facets.vertices = std::move(file.mesh.vertices);
  facets.notes = std::move(file.mesh.notes);
}

void addFacets(void (*read)(const std::string&, MeshBuilder&), const std::string& content,
               Facets& facets) {
  MeshBuilder mesh(facets.name);
  mesh.dividePolygons();
  read(content, mesh);
  addFacets(mesh.finish(), facets);
}

}  // namespace

void readMshFacets(const std::string& content, Facets& facets) {
  addFacets(&readMsh, content, facets);
}
void readVtuFacets(const std::string& content, Facets& facets) {
  addFacets(&readVtu, content, facets);
}
void readVtkFacets(const std::string& content, Facets& facets) {
  addFacets(&readVtk, content, facets);
}
void readPlyFacets(const std::string& content, Facets& facets) {
  addFacets(&readPly, content, facets);
}
void readOffFacets(const std::string& content, Facets& facets) {
  addFacets(&readOff, content, facets);
}

}  // namespace af2::geometry
