// Meshes a CAD model with AF2 and prints what the drivers of the peers print:
//   whole_mesh_benchmark [--optimize] [--threads N] MODEL SIZE [RULES]
// Without --optimize: the raw front. Without --threads: one thread, and seconds of user time; with
// it, seconds by the clock. RULES: a rule file, else that of `af2 mesh`.
// whole_mesh_benchmark.py runs this beside the peers.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <optional>
#include <vector>

#include "dsl/load/rule_file.h"
#include "engine/base/stopwatch.h"
#include "geometry/occ/run/mesh_model.h"
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
  const char* model = "";
  double size = 0;
  const char* rules = AF2_SOURCE_RULES "/tri/even.af2";
  bool optimize = false;
  int threads = 0;  ///< 0: not given
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
  geometry::MeshingOptions options;
  options.sizes.size = task.size;
  options.threads = std::max(task.threads, 1);
  options.optimize = task.optimize;

  const double start = af2::benchmark::userSeconds();
  const af2::Stopwatch clock;
  const geometry::ModelMesh mesh = geometry::meshModel(model, algorithm, options);
  const double seconds = task.threads > 0 ? clock.seconds() : af2::benchmark::userSeconds() - start;

  if (!isComplete(mesh)) return 3;
  af2::benchmark::printResult(stdout, seconds, qualitiesOf(mesh));
  return 0;
}

/// Nothing if the arguments are no task.
std::optional<Task> taskOf(std::vector<const char*> arguments) {
  Task task;
  std::size_t next = 0;
  for (; next < arguments.size() && std::strncmp(arguments[next], "--", 2) == 0; ++next) {
    const bool isThreads = std::strcmp(arguments[next], "--threads") == 0;
    if (std::strcmp(arguments[next], "--optimize") == 0)
      task.optimize = true;
    else if (isThreads && next + 1 < arguments.size() && std::atoi(arguments[next + 1]) > 0)
      task.threads = std::atoi(arguments[++next]);
    else
      return std::nullopt;
  }
  const std::size_t left = arguments.size() - next;
  if (left < 2 || left > 3) return std::nullopt;
  task.model = arguments[next];
  task.size = std::atof(arguments[next + 1]);
  if (left == 3) task.rules = arguments[next + 2];
  return task;
}

}  // namespace

int main(int argc, char** argv) {
  const std::optional<Task> task = taskOf({argv + 1, argv + argc});
  if (!task) {
    std::fprintf(stderr,
                 "usage: whole_mesh_benchmark [--optimize] [--threads N] MODEL SIZE [RULES]\n");
    return 2;
  }
  try {
    return run(*task);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "whole_mesh_benchmark: %s\n", error.what());
    return 1;
  }
}
