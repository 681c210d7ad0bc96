// Meshes a CAD model from within a program: embedding MODEL SIZE OUTPUT
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include <af2/dsl/rule_file.h>
#include <af2/engine/algorithm.h>
#include <af2/engine/error.h>
#include <af2/geometry/mesh_files.h>
#include <af2/geometry/mesh_model.h>

int main(int count, char** arguments) {
  if (count != 4) {
    std::fprintf(stderr, "usage: embedding MODEL SIZE OUTPUT\n");
    return 2;
  }
  try {
    const af2::dsl::LoadedRules loaded = af2::dsl::loadRules(RULES);
    if (!loaded.rules) throw af2::InputError(af2::dsl::toPretty(loaded.diagnostics));
    const af2::AF2Algorithm algorithm(loaded.rules);

    af2::geometry::MeshingOptions options;
    options.sizes.size = std::atof(arguments[2]);
    const af2::geometry::Model model = af2::geometry::readModel(arguments[1]);
    const af2::geometry::ModelMesh mesh = af2::geometry::meshModel(model, algorithm, options);

    // A face that cannot be meshed, or fails the checks, does not affect the others; it is
    // reported.
    bool isWhole = mesh.findings.empty();
    for (const std::string& lack : mesh.findings) std::fprintf(stderr, "%s\n", lack.c_str());
    for (const af2::geometry::FaceReport& face : mesh.faces) {
      if (face.status == af2::geometry::FaceStatus::Complete) continue;
      std::fprintf(stderr, "face %d: %s\n", face.id, face.reason.c_str());
      isWhole = false;
    }
    af2::geometry::writeMesh(mesh, arguments[3]);
    std::printf("%zu vertices, %zu elements\n", mesh.vertices.size(), mesh.elements.size());
    return isWhole ? 0 : 3;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
