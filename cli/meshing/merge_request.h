// The options that let meshes cross edges of a CAD model.
#pragma once

#include <CLI/App.hpp>
#include <set>
#include <string>
#include <vector>

#include "cli/meshing/model_formats.h"

namespace af2::cli {

/// As typed.
struct MergeOptions {
  std::vector<std::string> angle;  ///< [0]; empty text: the usual one; empty: not asked
  std::string narrow;
  std::vector<std::string> kept;
};

/// What was asked for, before the model is known.
struct MergeAsked {
  bool isAsked = false;
  double angle = 0;    ///< degrees; 0: the usual one
  double narrow = -1;  ///< share of the size; below 0: the usual one
  std::set<int> keptEdges;
  std::vector<std::string> keptAround;
};

void declareMerge(CLI::App& command, MergeOptions& options);
/// Throws UsageError for values that are no angle, share, edge or name, for these options without
/// --merge, and for models that are no CAD models.
MergeAsked checkedMerge(const MergeOptions& options, ModelKind kind);

}  // namespace af2::cli
