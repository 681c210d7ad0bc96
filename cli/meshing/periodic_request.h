// The option that makes faces of a CAD model periodic.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cli/meshing/model_formats.h"

namespace af2::cli {

struct PeriodicOptions {
  std::vector<std::string> asked;  ///< as typed
};

/// A face by its number, or by a name if that is not empty.
struct PeriodicFace {
  int id = 0;
  std::string name = {};
};

/// What was asked for, before the model is known.
struct PeriodicFaces {
  std::vector<std::string> directions;  ///< "x", "y", "z"
  std::vector<std::pair<PeriodicFace, PeriodicFace>> pairs;

  bool areAsked() const { return !directions.empty() || !pairs.empty(); }
};

void declarePeriodic(CLI::App& command, PeriodicOptions& options);
/// Throws UsageError for what is neither a direction nor a pair of faces, and for models that are
/// no CAD models.
PeriodicFaces checkedPeriodic(const PeriodicOptions& options, ModelKind kind);

}  // namespace af2::cli
