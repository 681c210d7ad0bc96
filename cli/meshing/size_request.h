// The options of `af2 mesh` about wanted sizes.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "geometry/sizes/sizes.h"

namespace af2::cli {

/// The options as they were typed; empty: not given.
struct SizeOptions {
  std::string size, smallest, largest, curvature, proximity, grading, file, chord;
  std::vector<std::string> faceSizes, edgeSizes, faceChords, fields;
  bool fewest = false;
};

void declareSizeOptions(CLI::App& command, SizeOptions& options);

/// Throws UsageError for contradictory options, InputError for a file that cannot be read.
geometry::Sizes checkedSizes(const SizeOptions& options);

}  // namespace af2::cli
