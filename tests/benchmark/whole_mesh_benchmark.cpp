// Meshes a CAD model with AF2 on one thread and prints what the drivers of the peers print:
//   whole_mesh_benchmark [--optimize] MODEL SIZE
// Without --optimize: the raw front. whole_mesh_benchmark.py runs this beside the peers.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <vector>

#include "dsl/rule_file.h"
#include "geometry/occ/mesh_model.h"
#include "result_line.h"

namespace {

namespace geometry = af2::geometry;

af2::benchmark::Corner cornerOf(const geometry::ModelMesh& mesh, af2::VertexId vertex) {
  const af2::Point3& p = mesh.vertices[vertex.value];
  return {p.x, p.y, p.z};
}

std::vector<double> qualitiesOf(const geometry::ModelMesh& mesh) {
  std::vector<double> qualities;
  qualities.reserve(mesh.elements.size());
  for (const af2::Element& element : mesh.elements) {
    qualities.push_back(af2::benchmark::triangleQuality(cornerOf(mesh, element.corners[0]),
                                                        cornerOf(mesh, element.corners[1]),
                                                        cornerOf(mesh, element.corners[2])));
  }
  return qualities;
}

bool isComplete(const geometry::ModelMesh& mesh) {
  for (const geometry::FaceReport& face : mesh.faces) {
    if (face.status != geometry::FaceStatus::Complete) return false;
  }
  return !mesh.elements.empty();
}

int run(const char* file, double size, bool optimize) {
  const auto loaded = af2::dsl::loadRules(AF2_SOURCE_RULES "/tri/even.af2");
  if (!loaded.rules) {
    std::fprintf(stderr, "%s", af2::dsl::toPretty(loaded.diagnostics).c_str());
    return 1;
  }
  const af2::AF2Algorithm algorithm(loaded.rules);
  const geometry::Model model = geometry::readModel(file);
  geometry::ModelMeshingOptions options;
  options.sizes.size = size;
  options.threads = 1;
  options.optimize = optimize;

  const double start = af2::benchmark::userSeconds();
  const geometry::ModelMesh mesh = geometry::meshModel(model, algorithm, options);
  const double seconds = af2::benchmark::userSeconds() - start;

  if (!isComplete(mesh)) return 3;
  af2::benchmark::printResult(stdout, seconds, qualitiesOf(mesh));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const bool optimize = argc == 4 && std::strcmp(argv[1], "--optimize") == 0;
  if (argc != 3 && !optimize) {
    std::fprintf(stderr, "usage: whole_mesh_benchmark [--optimize] MODEL SIZE\n");
    return 2;
  }
  try {
    return run(argv[argc - 2], std::atof(argv[argc - 1]), optimize);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "whole_mesh_benchmark: %s\n", error.what());
    return 1;
  }
}
