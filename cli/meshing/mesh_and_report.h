// A run of `af2 mesh` from the request to its files and its summary.
#pragma once

#include <functional>

#include "cli/meshing/mesh_request.h"
#include "cli/meshing/mesh_run.h"
#include "cli/program/supervisor.h"
#include "geometry/io/report.h"

namespace af2::cli {

/// Who watches a run.
struct RunWatch {
  StopFunction stop = neverStopped;
  RunLog* log = nullptr;             ///< of a supervised run
  const GivenUp* givenUp = nullptr;  ///< faces that must not be tried again
  /// Told the mesh before files are written; may be empty.
  std::function<void(const geometry::ModelMesh&)> meshed = {};
};

/// Meshes the model, writes the files and prints the summary. Returns the exit code.
///
/// Throws what `runMesh` and the loading of rules throw.
int meshAndReport(const MeshRequest& request, const RunWatch& watch);

void writeReportIfAsked(const MeshRequest& request, const geometry::RunReport& report,
                        const geometry::ModelMesh& mesh);

}  // namespace af2::cli
