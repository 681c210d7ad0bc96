#include "cli/meshing/mesh_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "cli/meshing/model_runs.h"
#include "cli/program/usage_error.h"
#include "engine/base/error.h"

namespace af2::cli {

namespace {

void checkId(const std::string& option, const char* kind, int id, int count) {
  if (id <= count) return;
  const char* hint = std::string_view(kind) == "edge" ? " --edges" : "";
  throw UsageError(
      fmt::format("{}: there is no {} {}; the model has {}s 1 to {} (see af2 inspect{})", option,
                  kind, id, kind, count, hint));
}

}  // namespace

void checkIds(const MeshRequest& request, int faces, int edges) {
  for (const int face : request.faces) checkId("--faces", "face", face, faces);
  for (const auto& [face, size] : request.sizes.faceSizes)
    checkId("--face-size", "face", face, faces);
  for (const auto& [edge, size] : request.sizes.edgeSizes)
    checkId("--edge-size", "edge", edge, edges);
}

void checkIds(const MeshRequest& request, const geometry::DomainModel& model) {
  int edges = 0;
  for (const geometry::DomainCurve& curve : model.curves) edges = std::max(edges, curve.id);
  checkIds(request, static_cast<int>(model.faces.size()), edges);
}

void setOptions(const MeshRequest& request, const RunControl& control, ProgressBar& bar,
                geometry::DomainMeshingOptions& options) {
  setSizes(request.sizes, options);
  options.partSizes = request.sizes.file.parts;
  setRun(request, control, options);
  options.progress = [&bar](const Progress& progress) {
    bar.show("meshing", 0, fmt::format("{} elements", progress.elements));
  };
}

geometry::ModelMesh runMesh(const MeshRequest& request, std::shared_ptr<const RuleSet> rules,
                            const RunControl& control) {
  const AF2Algorithm algorithm(std::move(rules));
  if (request.isPlanar()) return runPlanar(request, algorithm, control);
  if (request.isFaceted()) return runFaceted(request, algorithm, control);
#if AF2_HAVE_OCC
  return runCad(request, algorithm, control);
#else
  throw InputError("'" + request.model.string() +
                   "' is no .poly file, and this af2 was built without OpenCASCADE; build it with "
                   "-DAF2_BUILD_OCC=ON");
#endif
}

}  // namespace af2::cli
