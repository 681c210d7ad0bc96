// The unit of length in mesh files: --scale and --unit.
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "cli/meshing/model_formats.h"

namespace af2::cli {

/// As they were typed.
struct ScaleOptions {
  std::string scale, unit;
};

struct OutputScale {
  double factor = 1;  ///< coordinates in files are those of the mesh times this
  std::string unit;   ///< that the files are in; empty: --unit was not given
};

void declareScale(CLI::App& command, ScaleOptions& options);

/// Throws UsageError for options that are wrong, contradict each other, or do not suit models of
/// this kind.
OutputScale checkedScale(const ScaleOptions& options, ModelKind kind);

/// Throws UsageError if --unit was given and the model does not say its unit. AF2 takes all others
/// to millimetres.
void checkUnit(const OutputScale& scale, const std::string& unitOfModel);

}  // namespace af2::cli
