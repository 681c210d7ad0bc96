// One runner for each kind of model; runMesh picks.
#pragma once

#include "cli/meshing/mesh_run.h"
#include "cli/program/progress_bar.h"
#include "engine/base/stopwatch.h"
#include "engine/run/algorithm.h"
#include "geometry/domain/domain_model.h"

namespace af2::cli {

/// What models of every kind take from a request, into the options of theirs.
template <class Sizes>
void setSizes(const SizeRequest& request, Sizes& sizes) {
  sizes.size = request.size;
  sizes.minSize = request.smallest;
  sizes.maxSize = request.largest;
  sizes.elementsPerTurn = request.elementsPerTurn;
  sizes.elementsAcross = request.elementsAcross;
  sizes.growth = request.growth;
  sizes.faceSizes = request.faceSizes;
  sizes.edgeSizes = request.edgeSizes;
  sizes.sources = request.file.sources;
}

template <class Options>
void setRun(const MeshRequest& request, const RunControl& control, Options& options) {
  options.edgePoints = request.edgePoints;
  options.faces = request.faces;
  options.chart = request.chart;
  options.order = request.order;
  options.optimize = request.optimize;
  options.threads = request.threads;
  options.stop = control.stop;
}

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
