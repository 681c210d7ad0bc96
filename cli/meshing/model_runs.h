// One runner for each kind of model; runMesh chooses among them.
#pragma once

#include "cli/meshing/mesh_run.h"
#include "cli/program/progress_bar.h"
#include "engine/base/stopwatch.h"
#include "engine/run/algorithm.h"
#include "geometry/domain/domain_model.h"

namespace af2::cli {

/// The meshing options of a request, connected with the progress bar, the request to stop and the
/// log of faces. `control` and `bar` must outlive the options.
///
/// firstFace  added to the face numbers in the log
geometry::MeshingOptions optionsOf(const MeshRequest& request, const RunControl& control,
                                   ProgressBar& bar, int firstFace = 0);

/// Throw UsageError for faces and edges that the model does not have.
void checkIds(const MeshRequest& request, int faces, int edges);
void checkIds(const MeshRequest& request, const geometry::DomainModel& model);

/// Tells the control the names of a model.
void tellNames(const RunControl& control, const geometry::DomainModel& model);

geometry::ModelMesh runPlanar(const MeshRequest& request, const AF2Algorithm& algorithm,
                              const RunControl& control);
geometry::ModelMesh runFaceted(const MeshRequest& request, const AF2Algorithm& algorithm,
                               const RunControl& control);
geometry::ModelMesh runCad(const MeshRequest& request, const AF2Algorithm& algorithm,
                           const RunControl& control);

}  // namespace af2::cli
