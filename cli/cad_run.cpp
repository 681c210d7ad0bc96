// `af2 mesh` for CAD models.
#include <fmt/core.h>

#include <algorithm>

#include "cli/model_runs.h"
#include "cli/progress_bar.h"
#include "cli/usage_error.h"
#include "geometry/occ/mesh_model.h"

namespace af2::cli {
namespace {

void checkId(const std::string& option, const char* kind, int id, int count) {
  if (id <= count) return;
  throw UsageError(fmt::format("{}: there is no {} {}; the model has {} 1 to {} (see af2 inspect)",
                               option, kind, id, kind, count));
}

void checkIds(const MeshRequest& request, const geometry::Model& model) {
  for (const int face : request.faces) checkId("--faces", "face", face, model.faceCount());
  for (const auto& [face, size] : request.faceSizes) {
    checkId("--face-size", "face", face, model.faceCount());
  }
  for (const auto& [edge, size] : request.edgeSizes) {
    checkId("--edge-size", "edge", edge, model.edgeCount());
  }
}

geometry::ModelMeshingOptions meshingOptions(const MeshRequest& request, const RunControl& control,
                                             ProgressBar& bar) {
  geometry::ModelMeshingOptions options;
  options.sizes.size = request.size;
  options.sizes.faceSizes = request.faceSizes;
  options.sizes.edgeSizes = request.edgeSizes;
  options.faces = request.faces;
  options.threads = request.threads;
  options.optimize = request.optimize;
  options.stop = control.stop;
  options.progress = [&bar](const geometry::ModelProgress& progress) {
    const double part = progress.workTotal > 0 ? progress.workDone / progress.workTotal : 0;
    bar.show("meshing", part, fmt::format("{}/{} faces", progress.facesDone, progress.faces));
  };
  return options;
}

}  // namespace

geometry::ModelMesh runCad(const MeshRequest& request, const AF2Algorithm& algorithm,
                           const RunControl& control) {
  ProgressBar bar(control.showProgress);
  bar.show("reading", 0, request.model.filename().string());
  Stopwatch reading;
  const geometry::Model model = geometry::readModel(request.model);
  const double readSeconds = reading.seconds();
  checkIds(request, model);
  geometry::ModelMesh mesh =
      geometry::meshModel(model, algorithm, meshingOptions(request, control, bar));
  mesh.seconds.read = readSeconds;
  return mesh;
}

}  // namespace af2::cli
