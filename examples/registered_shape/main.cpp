// Meshes a planar domain with rules that call a custom zone shape:
// registered_shape DOMAIN.poly SIZE OUTPUT
#include <cstdio>
#include <cstdlib>
#include <exception>

#include <af2/dsl/registry.h>
#include <af2/dsl/rule_file.h>
#include <af2/engine/algorithm.h>
#include <af2/engine/error.h>
#include <af2/geometry/mesh_files.h>
#include <af2/geometry/mesh_planar.h>
#include "egg.h"

namespace {

int run(const char* domainFile, double size, const char* output) {
  af2::dsl::Registry registry;
  registry.addShape({.name = "egg", .parameters = "ppn", .make = makeEgg});  // two points, a number
  af2::dsl::LoadOptions options;
  options.registry = &registry;
  const af2::dsl::LoadedRules loaded = af2::dsl::loadRules(RULES, options);
  if (!loaded.rules) throw af2::InputError(af2::dsl::toPretty(loaded.diagnostics));

  const af2::AF2Algorithm algorithm(loaded.rules);
  af2::geometry::MeshingOptions meshing;
  meshing.sizes.size = size;
  const af2::geometry::ModelMesh mesh =
      af2::geometry::meshPlanar(af2::geometry::readPoly(domainFile), algorithm, meshing);
  for (const af2::geometry::FaceReport& face : mesh.faces)
    if (face.status != af2::geometry::FaceStatus::Complete)
      throw af2::InputError("face not meshed: " + face.reason);
  af2::geometry::writeMesh(mesh, output);
  std::printf("%zu vertices, %zu elements\n", mesh.vertices.size(), mesh.elements.size());
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    std::fprintf(stderr, "usage: registered_shape DOMAIN.poly SIZE OUTPUT\n");
    return 2;
  }
  try {
    return run(arguments[1], std::atof(arguments[2]), arguments[3]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
