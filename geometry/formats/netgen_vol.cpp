// Netgen's .vol: a surface mesh with the domains on both sides of each face, from which Netgen
// makes tetrahedra. Each model face is a boundary condition, each solid a domain.
#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "geometry/formats/msh_volumes.h"
#include "geometry/io/formats.h"
#include "geometry/mesh/triangles_of.h"

namespace af2::geometry {
namespace {

/// Netgen reads names word by word.
std::string wordOf(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return c <= ' '; }, '_');
  return name;
}

void putNames(const char* section, const std::map<int, std::string>& names, OutputFile& file) {
  file.text(section);
  file.text("\n");
  file.number(names.size());
  file.text("\n");
  for (const auto& [number, name] : names) {
    file.number(number);
    file.text(" " + wordOf(name) + "\n");
  }
  file.text("\n");
}

/// The numbers of the solids behind and before a face; 0: none.
struct Domains {
  int in = 0, out = 0;
};

class VolWriter {
 public:
  VolWriter(const ModelMesh& mesh, OutputFile& file) : mesh_(mesh), file_(file) {
    for (const FaceReport& face : mesh.faces) {
      const auto number = static_cast<int>(numbers_.size()) + 1;
      numbers_[face.id] = number;
      names_[number] = face.name.empty() ? "face " + std::to_string(face.id) : face.name;
    }
    for (const MshVolume& volume : mshVolumes(mesh)) {
      solids_[volume.number] = volume.name;
      for (const int face : volume.surfaces)
        (face > 0 ? domains_[face].in : domains_[-face].out) = volume.number;
    }
  }

  void write() {
    file_.text("mesh3d\ndimension\n3\ngeomtype\n0\n\n");
    putTriangles();
    file_.text("volumeelements\n0\n\n");
    putPoints();
    putNames("materials", solids_, file_);
    putNames("bcnames", names_, file_);
    file_.text("endmesh\n");
  }

 private:
  /// surface, boundary condition, domain behind and before, corners
  void putTriangles() {
    file_.text("surfaceelements\n");
    std::size_t count = 0;
    for (const Element& element : mesh_.elements) count += element.isQuad() ? 2 : 1;
    file_.number(count);
    file_.text("\n");
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      const int face = mesh_.face[e];
      const Domains domains = domains_[face];
      for (const auto& [a, b, c] : trianglesOf(mesh_, mesh_.elements[e])) {
        for (const int number : {numbers_[face], numbers_[face], domains.in, domains.out}) {
          file_.number(number);
          file_.text(" ");
        }
        file_.text("3");
        for (const VertexId v : {a, b, c}) {
          file_.text(" ");
          file_.number(v.value + 1);
        }
        file_.text("\n");
      }
    }
    file_.text("\n");
  }

  void putPoints() {
    const auto vertices = cornerVertices(mesh_);
    file_.text("points\n");
    file_.number(vertices.size());
    file_.text("\n");
    for (const Point3& point : vertices) {
      const char* before = "";
      for (const double x : {point.x, point.y, point.z}) {
        file_.text(std::exchange(before, " "));
        file_.number(x);
      }
      file_.text("\n");
    }
    file_.text("\n");
  }

  const ModelMesh& mesh_;
  OutputFile& file_;
  std::map<int, int> numbers_;  ///< of Netgen, by id of the face
  std::map<int, std::string> names_, solids_;
  std::map<int, Domains> domains_;  ///< by id of the face
};

}  // namespace

void writeVol(const ModelMesh& mesh, const Extras&, OutputFile& file) {
  VolWriter(mesh, file).write();
}

}  // namespace af2::geometry
