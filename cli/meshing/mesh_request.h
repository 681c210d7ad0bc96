// What `af2 mesh` was asked to do, checked as far as the command line alone allows.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/meshing/model_formats.h"
#include "cli/meshing/size_request.h"
#include "geometry/io/line_elements.h"
#include "geometry/meshing/meshing_options.h"

namespace af2::cli {

/// The options as they were typed.
struct MeshOptions {
  std::string model, rules = "tri/even.af2", faces, report;
  SizeOptions sizes;
  std::vector<std::string> outputs;
  int threads = 0, order = 1;
  std::string boundary, featureAngle, chart, healTolerance;
  bool quiet = false, rawFront = false, keepBoundary = false, heal = false, edges = false;
};

void declareMeshOptions(CLI::App& command, MeshOptions& options);

/// The options of all verbs that can heal a model.
void declareHealing(CLI::App& command, bool& heal, std::string& tolerance);
/// Throws UsageError: the model is of a kind that cannot be healed.
[[noreturn]] void refuseHealing();
/// 0 if none is given. Throws UsageError for one that is no length, or without `heal`.
double checkedHealTolerance(bool heal, const std::string& tolerance);

struct MeshRequest {
  std::filesystem::path model, rules, report;  ///< no report if empty
  std::vector<std::filesystem::path> outputs;
  geometry::MeshingOptions options;  ///< what is wanted of the mesh
  bool quiet = false;
  geometry::LinesAlong lines = geometry::LinesAlong::Boundaries;

  bool heal = false;         ///< repair the model first
  double healTolerance = 0;  ///< in its unit; 0: by its size
  /// How the repairs took the program down, so that they are left out now; empty: they did not.
  std::string healingEnd;

  /// Whether the numbers of faces and edges mean something: they are not the same after healing.
  bool asksByNumber() const {
    return !options.faces.empty() || !options.sizes.faceSizes.empty() ||
           !options.sizes.edgeSizes.empty() || !options.edgePoints.empty();
  }

  ModelKind kind() const { return modelKindOf(model); }
};

/// Throws UsageError for options that make no sense or files that cannot be written, InputError for
/// files that cannot be read.
MeshRequest checkedRequest(const MeshOptions& options);

}  // namespace af2::cli
