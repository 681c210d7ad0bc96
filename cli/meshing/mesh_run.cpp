#include "cli/meshing/mesh_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "cli/meshing/model_runs.h"
#include "cli/program/usage_error.h"

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
  for (const int face : request.options.faces) checkId("--faces", "face", face, faces);
  for (const auto& [face, size] : request.options.sizes.faceSizes)
    checkId("--face-size", "face", face, faces);
  for (const auto& [face, bound] : request.options.sizes.chords.faces)
    checkId("--face-chord", "face", face, faces);
  for (const auto& [edge, size] : request.options.sizes.edgeSizes)
    checkId("--edge-size", "edge", edge, edges);
  for (const geometry::LayerRequest& layers : request.options.layers) {
    for (const int edge : layers.edges) checkId("--layers", "edge", edge, edges);
    for (const int face : layers.faces) checkId("--layers", "face", face, faces);
  }
}

void checkIds(const MeshRequest& request, const geometry::DomainModel& model) {
  int edges = 0;
  for (const geometry::DomainCurve& curve : model.curves) edges = std::max(edges, curve.id);
  checkIds(request, static_cast<int>(model.faces.size()), edges);
}

void tellNames(const RunControl& control, const geometry::DomainModel& model) {
  if (!control.names) return;
  std::vector<std::string> names;
  for (const geometry::DomainFace& face : model.faces) names.push_back(face.name);
  control.names(names, model.groups);
}

geometry::MeshingOptions optionsOf(const MeshRequest& request, const RunControl& control,
                                   ProgressBar& bar, int firstFace) {
  geometry::MeshingOptions options = request.options;
  options.stop = control.stop();
  if (control.log || control.observer)
    options.observer = [&control, firstFace](int face) -> AF2MeshingObserver* {
      if (control.log) control.log->begin(firstFace + face);
      return control.observer ? control.observer(firstFace + face) : nullptr;
    };
  options.progress = [&bar, &control, done = 0](const geometry::ModelProgress& progress) mutable {
    if (control.log) progress.facesDone > done ? control.log->finish() : control.log->beat();
    done = progress.facesDone;
    const double part = progress.workTotal > 0 ? progress.workDone / progress.workTotal : 0;
    bar.show("meshing", part, fmt::format("{}/{} faces", progress.facesDone, progress.faces));
  };
  return options;
}

geometry::ModelMesh runMesh(const MeshRequest& request, std::shared_ptr<const RuleSet> rules,
                            const RunControl& control) {
  const AF2Algorithm algorithm(std::move(rules));
  switch (request.kind()) {
    case ModelKind::Planar:
      return runPlanar(request, algorithm, control);
    case ModelKind::Faceted:
      return runFaceted(request, algorithm, control);
    case ModelKind::Cad:
      break;
  }
#if AF2_HAVE_OCC
  return runCad(request, algorithm, control);
#else
  refuseCadModel(request.model);
#endif
}

}  // namespace af2::cli
