// The options that make parts of a CAD model share their faces, which several verbs have.
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "cli/meshing/model_formats.h"

namespace af2::cli {

/// As typed.
struct ImprintFlags {
  bool imprint = false, glue = false;
  std::string tolerance, overlap;
};

struct ImprintRequest {
  bool isAsked = false;
  bool onlyEqual = false;    ///< --glue
  double tolerance = 0;      ///< in the model's unit; 0: derived from its size
  std::string overlap = {};  ///< "first", "last" or "cut"; empty: refuse
  /// How the imprint crashed or hung, which is why it is left out now; empty: it did not.
  std::string end = {};
};

/// Seconds that OpenCASCADE may take to imprint a model.
inline constexpr double kImprintSeconds = 120;

void declareImprint(CLI::App& command, ImprintFlags& flags);
/// Throws UsageError for options that contradict each other or do not fit the kind of model.
ImprintRequest checkedImprint(const ImprintFlags& flags, ModelKind kind);

}  // namespace af2::cli
