// One runner for each kind of model; runMesh picks.
#pragma once

#include <chrono>

#include "cli/mesh_run.h"
#include "engine/algorithm.h"

namespace af2::cli {

/// Seconds since it was made.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

geometry::ModelMesh runPlanar(const MeshRequest& request, const AF2Algorithm& algorithm,
                              const RunControl& control);
geometry::ModelMesh runCad(const MeshRequest& request, const AF2Algorithm& algorithm,
                           const RunControl& control);

}  // namespace af2::cli
