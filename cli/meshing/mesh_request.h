// The request of `af2 mesh`, checked as far as the command line alone allows.
#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/meshing/imprint_request.h"
#include "cli/meshing/merge_request.h"
#include "cli/meshing/model_formats.h"
#include "cli/meshing/output_scale.h"
#include "cli/meshing/periodic_request.h"
#include "cli/meshing/size_request.h"
#include "cli/rules/rule_loading.h"
#include "geometry/io/mesh_files.h"
#include "geometry/io/points_file.h"
#include "geometry/meshing/meshing_options.h"

namespace af2::cli {

/// The options as they were typed.
struct MeshOptions {
  std::string model, format, rules, faces, report, stuckTests, trace, traceFaces;
  SizeOptions sizes;
  std::vector<std::string> outputs;
  int threads = 0, order = 1;
  std::uint64_t maxMemory = 0;  ///< bytes; 0: what is free
  bool coarsen = false, stream = false;
  std::string points, boundary, featureAngle, chart, groups, healTolerance, elements = "any",
                                                                            quality;
  bool quiet = false, rawFront = false, strictRules = false, unchecked = false;
  ImprintFlags imprint;
  ScaleOptions scale;
  PeriodicOptions periodic;
  MergeOptions merge;
  std::vector<std::string> layers;
  std::vector<std::string> plugins;  ///< libraries that register names for the rules
  bool keepBoundary = false, heal = false, edges = false, statistics = false, compress = false;
};

void declareMeshOptions(CLI::App& command, MeshOptions& options);

/// Declares the options about healing, which several verbs share.
void declareHealing(CLI::App& command, bool& heal, std::string& tolerance);
/// Throws UsageError: models of this kind cannot be healed.
[[noreturn]] void refuseHealing();
/// Returns 0 if none is given. Throws UsageError if it is not a length, or without `heal`.
double checkedHealTolerance(bool heal, const std::string& tolerance);

/// The arguments of `af2 mesh` that were given, without those that only name outputs.
std::vector<std::string> argumentsOf(const CLI::App& command);
/// The options that such arguments stand for. Throws InputError if they are not arguments.
MeshOptions optionsFrom(std::vector<std::string> arguments);

struct MeshRequest {
  std::filesystem::path model, rules;
  std::filesystem::path report, stuckTests, trace;  ///< empty: not written
  std::vector<int> traceFaces;                      ///< that are traced; empty, and no names: all
  std::vector<std::string> traceNames;              ///< of faces and groups that are traced, too
  std::vector<std::string> arguments;               ///< see argumentsOf; only for traces
  std::vector<std::filesystem::path> outputs;
  geometry::MeshingOptions options;  ///< the options for meshing
  bool quiet = false;
  bool statistics = false;  ///< the report has the statistics of the rules
  RuleLoading ruleLoading;
  geometry::FileOptions fileOptions;
  OutputScale scale;

  bool heal = false;         ///< repair the model first
  double healTolerance = 0;  ///< in the model's unit; 0: derived from its size
  /// How the repairs crashed or hung, which is why they are left out now; empty: they did not.
  std::string healingEnd;

  ImprintRequest imprint;
  PeriodicFaces periodic;
  MergeAsked merge;
  geometry::InsideFaces inside;  ///< what the mesh is to keep inside faces

  /// Whether options name faces or edges by number: healing changes the numbers.
  bool asksByNumber() const;

  ModelKind kind() const { return modelKindOf(model); }
};

/// Throws UsageError for contradictory options or files that cannot be written, InputError for
/// files that cannot be read.
MeshRequest checkedRequest(const MeshOptions& options);

}  // namespace af2::cli
