// One runner for each kind of model; runMesh picks.
#pragma once

#include "cli/mesh_run.h"
#include "cli/progress_bar.h"
#include "engine/algorithm.h"
#include "engine/stopwatch.h"
#include "geometry/domain_model.h"

namespace af2::cli {

/// What all domains take from a request. The progress bar must outlive the options.
void setOptions(const MeshRequest& request, const RunControl& control, ProgressBar& bar,
                geometry::DomainMeshingOptions& options);

/// Throw UsageError for faces and edges that a model does not have.
void checkIds(const MeshRequest& request, int faces, int edges);
void checkIds(const MeshRequest& request, const geometry::DomainModel& model);

geometry::ModelMesh runPlanar(const MeshRequest& request, const AF2Algorithm& algorithm,
                              const RunControl& control);
geometry::ModelMesh runFaceted(const MeshRequest& request, const AF2Algorithm& algorithm,
                               const RunControl& control);
geometry::ModelMesh runCad(const MeshRequest& request, const AF2Algorithm& algorithm,
                           const RunControl& control);

}  // namespace af2::cli
