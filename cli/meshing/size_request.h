// The options of `af2 mesh` about wanted sizes.
#pragma once

#include <CLI/App.hpp>
#include <map>
#include <string>
#include <vector>

#include "geometry/io/size_file.h"

namespace af2::cli {

/// As they were typed; empty: not given.
struct SizeOptions {
  std::string size, smallest, largest, curvature, proximity, grading, file;
  std::vector<std::string> faceSizes, edgeSizes;
};

void declareSizeOptions(CLI::App& command, SizeOptions& options);

struct SizeRequest {
  double size = 0, smallest = 0;
  double largest;  ///< infinite if not given
  double elementsPerTurn = 0, elementsAcross = 0, growth = geometry::kDefaultGrowth;
  std::map<int, double> faceSizes, edgeSizes;
  geometry::SizeFile file;
};

/// Throws UsageError for options that make no sense, InputError for a file that cannot be read.
SizeRequest checkedSizes(const SizeOptions& options);

}  // namespace af2::cli
