// Reads the model of a request and meshes it: combines the rules, the readers and the meshers.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>

#include "cli/meshing/mesh_request.h"
#include "cli/program/supervisor.h"
#include "engine/rule/rule_set.h"
#include "engine/step/observer.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::cli {

/// Called once the model has been read: until then, a run cannot be stopped anyway.
using StopFunction = std::function<std::stop_token()>;

inline std::stop_token neverStopped() { return {}; }

struct RunControl {
  bool showProgress = true;
  StopFunction stop = neverStopped;
  /// The observer of a face, or null; called from several threads. Empty: no face has one.
  std::function<AF2MeshingObserver*(int face)> observer = {};
  RunLog* log = nullptr;             ///< log of a supervised run
  const GivenUp* givenUp = nullptr;  ///< faces that must not be tried again
  /// Told the names of the faces 1, 2, ... and the groups of a model before it is meshed.
  std::function<void(std::span<const std::string> names, std::span<const geometry::FaceGroup>)>
      names = {};
};

/// Throws InputError if the model cannot be used, UsageError if the request names faces or edges
/// that the model does not have.
geometry::ModelMesh runMesh(const MeshRequest& request, std::shared_ptr<const RuleSet> rules,
                            const RunControl& control);

}  // namespace af2::cli
