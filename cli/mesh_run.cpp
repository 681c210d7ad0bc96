#include "cli/mesh_run.h"

#include "cli/model_runs.h"
#include "engine/error.h"

namespace af2::cli {

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
