// The options that let meshes cross edges of a CAD model.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "cli/meshing/model_formats.h"
#include "geometry/occ/merge/merge_request.h"

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
  geometry::MergeRequest request;
};

void declareMerge(CLI::App& command, MergeOptions& options);
/// Throws UsageError for values that are no angle, share, edge or name, for these options without
/// --merge, for models that are no CAD models, and together with what cannot be combined with it.
MergeAsked checkedMerge(const MergeOptions& options, ModelKind kind, bool hasFewest = false);

}  // namespace af2::cli
