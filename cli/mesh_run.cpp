#include "cli/mesh_run.h"

#include <fmt/core.h>

#include "cli/model_runs.h"
#include "engine/error.h"

namespace af2::cli {

void setOptions(const MeshRequest& request, const RunControl& control, ProgressBar& bar,
                geometry::DomainMeshingOptions& options) {
  options.size = request.sizes.size;
  options.minSize = request.sizes.smallest;
  options.maxSize = request.sizes.largest;
  options.elementsPerTurn = request.sizes.elementsPerTurn;
  options.elementsAcross = request.sizes.elementsAcross;
  options.growth = request.sizes.growth;
  options.sources = request.sizes.file.sources;
  options.order = request.order;
  options.optimize = request.optimize;
  options.threads = request.threads;
  options.stop = control.stop;
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
