// Meshes a CAD model with AF2 on one thread and prints what the drivers of the peers print:
//   whole_mesh_benchmark [--optimize] MODEL SIZE [RULES]
// Without --optimize: the raw front. RULES: a rule file, else that of `af2 mesh`.
// whole_mesh_benchmark.py runs this beside the peers.
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

struct Task {
  const char* model;
  double size;
  const char* rules = AF2_SOURCE_RULES "/tri/even.af2";
  bool optimize = false;
};

int run(const Task& task) {
  af2::dsl::LoadOptions loading;
  loading.searchPaths = {AF2_SOURCE_RULES};
  const auto loaded = af2::dsl::loadRules(task.rules, loading);
  if (!loaded.rules) {
    std::fprintf(stderr, "%s", af2::dsl::toPretty(loaded.diagnostics).c_str());
    return 1;
  }
  const af2::AF2Algorithm algorithm(loaded.rules);
  const geometry::Model model = geometry::readModel(task.model);
  geometry::ModelMeshingOptions options;
  options.sizes.size = task.size;
  options.threads = 1;
  options.optimize = task.optimize;

  const double start = af2::benchmark::userSeconds();
  const geometry::ModelMesh mesh = geometry::meshModel(model, algorithm, options);
  const double seconds = af2::benchmark::userSeconds() - start;

  if (!isComplete(mesh)) return 3;
  af2::benchmark::printResult(stdout, seconds, qualitiesOf(mesh));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const bool optimize = argc > 1 && std::strcmp(argv[1], "--optimize") == 0;
  const int first = optimize ? 2 : 1;
  if (argc < first + 2 || argc > first + 3) {
    std::fprintf(stderr, "usage: whole_mesh_benchmark [--optimize] MODEL SIZE [RULES]\n");
    return 2;
  }
  Task task{argv[first], std::atof(argv[first + 1])};
  task.optimize = optimize;
  if (argc == first + 3) task.rules = argv[first + 2];
  try {
    return run(task);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "whole_mesh_benchmark: %s\n", error.what());
    return 1;
  }
}
