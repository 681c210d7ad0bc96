// One runner for each kind of model; runMesh picks.
#pragma once

#include "cli/mesh_run.h"
#include "engine/algorithm.h"
#include "engine/stopwatch.h"

namespace af2::cli {

geometry::ModelMesh runPlanar(const MeshRequest& request, const AF2Algorithm& algorithm,
                              const RunControl& control);
geometry::ModelMesh runFaceted(const MeshRequest& request, const AF2Algorithm& algorithm,
                               const RunControl& control);
geometry::ModelMesh runCad(const MeshRequest& request, const AF2Algorithm& algorithm,
                           const RunControl& control);

}  // namespace af2::cli
