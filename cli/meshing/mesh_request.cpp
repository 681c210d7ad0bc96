#include "cli/meshing/mesh_request.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>

#include "cli/meshing/layers_request.h"
#include "cli/meshing/output_checks.h"
#include "cli/program/number_lists.h"
#include "cli/program/usage_error.h"
#include "cli/rules/plugins.h"
#include "cli/rules/rules_location.h"
#include "engine/base/error.h"
#include "geometry/base/words.h"
#include "geometry/io/boundary_file.h"
#include "geometry/io/mesh_files.h"

namespace af2::cli {
namespace {

namespace fs = std::filesystem;

void checkReadable(const fs::path& model) {
  std::error_code ignored;
  const fs::file_status status = fs::status(model, ignored);
  if (!fs::exists(status)) throw InputError(fmt::format("there is no file '{}'", model.string()));
  if (fs::is_directory(status)) {
    throw InputError(
        fmt::format("'{}' is a directory; give a file: {}", model.string(), modelHelp()));
  }
  if (!fs::is_regular_file(status))
    throw InputError(fmt::format(
        "'{}' is not a regular file, but a model is read more than once; write it to a file first",
        model.string()));
}

std::string groupingWords() {
  std::vector<std::string_view> words;
  for (const auto& [word, kind] : geometry::groupings()) words.push_back(word);
  return geometry::listed(words, "and");
}

std::vector<geometry::Grouping> checkedGroups(const std::string& list) {
  std::vector<geometry::Grouping> groups;
  const auto known = geometry::groupings();
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t end = std::min(list.find(',', from), list.size());
    const std::string word = list.substr(from, end - from);
    const auto* const found =
        std::ranges::find_if(known.data(), known.data() + known.size(),
                             [&](const auto& row) { return row.first == word; });
    if (found == known.data() + known.size())
      throw UsageError(fmt::format("--groups {}: '{}' is no kind of group; there are {}", list,
                                   word, groupingWords()));
    groups.push_back(found->second);
    from = end + 1;
  }
  return groups;
}

std::string outputHelp() {
  std::string help = "file for the mesh; its extension selects the format:";
  for (const geometry::MeshFormat& format : geometry::meshFormats()) {
    help += fmt::format(" {}", format.extension);
  }
  return help + ". May be given several times";
}

}  // namespace

void declareMeshOptions(CLI::App& command, MeshOptions& options) {
  command.add_option("MODEL", options.model, modelHelp() + "; - stands for standard input")
      ->type_name("")
      ->required();
  command
      .add_option("--format", options.format,
                  "with - for the model: its format, as an extension such as step, if its content "
                  "does not tell")
      ->type_name("FORMAT");
  declareSizeOptions(command, options.sizes);
  command
      .add_option("-r,--rules", options.rules,
                  "rule file: a path, or the name of rules that come with AF2 [tri/even.af2, or "
                  "quad/classic.af2 with --elements quad]")
      ->type_name("FILE");
  command.add_option("-o,--output", options.outputs, outputHelp())
      ->type_name("FILE")
      ->take_all()
      ->expected(1);
  command
      .add_option("--faces", options.faces,
                  "mesh only these faces, by number or name, e.g. 3,7-9,inlet")
      ->type_name("FACES");
  command
      .add_option("--boundary", options.boundary,
                  "JSON file with the vertices along edges that are already divided")
      ->type_name("FILE");
  command
      .add_option(
          "--points", options.points,
          "JSON file with points and curves inside faces of a CAD model or a planar domain, which "
          "become vertices and edges")
      ->type_name("FILE");
  declareLayers(command, options.layers);
  command
      .add_option("--elements", options.elements,
                  "any, or quad: quadrilaterals only, with even numbers of edges on boundaries")
      ->type_name("KIND")
      ->check(CLI::IsMember({"any", "quad"}).description(""))
      ->capture_default_str();
  command
      .add_option("--quality", options.quality,
                  "fast, good or best: how long to look for better quadrilaterals")
      ->type_name("LEVEL")
      ->check(CLI::IsMember({"fast", "good", "best"}).description(""))
      ->capture_default_str();
  command.add_flag("--edges", options.edges,
                   "also write line elements along all edges of the model, in " +
                       extensionsThat(&geometry::MeshFormat::holdsLines, "and") + " files");
  command
      .add_option("--groups", options.groups,
                  "for " + extensionsThat(&geometry::MeshFormat::holdsGroups, "and") +
                      " files: each face is in one group only, of the first of these kinds in "
                      "which it has one: " +
                      groupingWords())
      ->type_name("KINDS");
  command.add_flag("--compress", options.compress,
                   "compress the arrays of " +
                       extensionsThat(&geometry::MeshFormat::isCompressible, "and") + " files");
  declareScale(command, options.scale);
  command.add_flag("--keep-boundary", options.keepBoundary,
                   "for " + formatNames(ModelKind::Planar, "and") +
                       " files: do not divide the segments of the boundary");
  command
      .add_option("--feature-angle", options.featureAngle,
                  "for " + formatNames(ModelKind::Faceted, "and") +
                      " files: keep edges at which the surface turns by more than this, default 40")
      ->type_name("DEGREES");
  command
      .add_option("--chart", options.chart,
                  "chart (2-D map) in which curved faces are meshed: " + geometry::chartNames() +
                      " (default auto); faces that have no such chart are meshed with auto")
      ->type_name("KIND");
  command
      .add_option("-j,--threads", options.threads,
                  "number of threads, 0: all cores; the mesh does not depend on it")
      ->type_name("N");
  command
      .add_option(
          "--max-memory", options.maxMemory,
          "memory for the mesh, such as 800M or 4G; sizes that need more are refused before "
          "meshing begins")
      ->transform(CLI::AsSizeValue(true).description(""))
      ->type_name("SIZE");
  command.add_flag("--coarsen", options.coarsen,
                   "larger sizes where those that are asked for need more memory than there is, or "
                   "than --max-memory allows");
  command.add_flag("--stream", options.stream,
                   "put faces on disk when they are done, which takes little memory; for " +
                       extensionsThat(&geometry::MeshFormat::holdsSpooled, "and") +
                       " files. Default: where the mesh would not fit into memory");
  command
      .add_option("--order", options.order,
                  "1 or 2: elements of order 2 have extra vertices, on the surface, at the middles "
                  "of their sides")
      ->type_name("N");
  declareHealing(command, options.heal, options.healTolerance);
  declareImprint(command, options.imprint);
  declarePeriodic(command, options.periodic);
  declareMerge(command, options.merge);
  command.add_flag("--no-optimize", options.rawFront,
                   "do not optimize the mesh that the front made");
  command.add_flag("--strict-rules", options.strictRules,
                   "only rules make elements: a face fails at the first front edge that no rule "
                   "takes, without further tries, and the exit code is 3");
  command.add_flag("--unchecked", options.unchecked,
                   "use the rules even if the checks of af2 check prove errors in them");
  command
      .add_option("--stuck-tests", options.stuckTests,
                  "file (.af2) for tests of the places where fronts got stuck, ready for af2 test")
      ->type_name("FILE");
  command
      .add_option("--trace", options.trace,
                  "file for the decisions of the run, for af2 explain, stats and trace")
      ->type_name("FILE");
  command
      .add_option("--trace-faces", options.traceFaces,
                  "with --trace: only these faces, by number or name, e.g. 3,7-9,inlet")
      ->type_name("FACES");
  addPluginOption(command, options.plugins);
  command.add_option("--report", options.report, "file for a report in JSON")->type_name("FILE");
  command.add_flag("--statistics", options.statistics,
                   "with --report: also what each rule did, as af2 stats prints it");
  command.add_flag("-q,--quiet", options.quiet, "print only errors and failures");
}

void declareHealing(CLI::App& command, bool& heal, std::string& tolerance) {
  command.add_flag(
      "--heal", heal,
      "repair a CAD model first: open loops, wires, small edges and faces, gaps, loose faces, "
      "orientation. All changes are reported");
  command
      .add_option("--heal-tolerance", tolerance,
                  "with --heal: close gaps and remove edges and faces up to this size; default: a "
                  "hundred-thousandth of the diagonal")
      ->type_name("SIZE");
}

double checkedHealTolerance(bool heal, const std::string& tolerance) {
  if (tolerance.empty()) return 0;
  if (!heal) throw UsageError("--heal-tolerance needs --heal");
  return parseSize("--heal-tolerance", tolerance);
}

void refuseHealing() {
  const std::string formats = formatNames(ModelKind::Cad, "and");
  throw UsageError("--heal is for " + (formats.empty() ? "CAD" : formats) + " files");
}

geometry::ChartKind checkedChart(const MeshOptions& options, const MeshRequest& request) {
  if (request.kind() == ModelKind::Planar)
    throw UsageError("--chart is for curved faces; a planar domain is its own chart");
  const auto kind = geometry::chartKindOf(options.chart);
  if (!kind)
    throw UsageError(
        fmt::format("--chart {}: choose one of {}", options.chart, geometry::chartNames()));
  return *kind;
}

QuadCleanUp checkedQuads(const MeshOptions& options) {
  QuadCleanUp quads;
  quads.onlyQuads = options.elements == "quad";
  if (quads.onlyQuads && (options.rawFront || options.strictRules))
    throw UsageError(
        fmt::format("--elements quad joins triangles after the fronts have closed; leave out {}",
                    options.rawFront ? "--no-optimize" : "--strict-rules"));
  if (!options.quality.empty())
    quads.depth = options.quality == "fast" ? 0 : options.quality == "best" ? 3 : 2;
  return quads;
}

std::vector<std::string> argumentsOf(const CLI::App& command) {
  const std::set<std::string> outputs{"--output",    "--report",      "--stuck-tests",
                                      "--trace",     "--trace-faces", "--quiet",
                                      "--unchecked", "--statistics",  "--stream"};
  std::vector<std::string> arguments;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || outputs.contains(option->get_name())) continue;
    for (const std::string& value : option->results()) {
      if (option->get_positional())
        arguments.push_back(value);
      else if (option->get_expected_max() == 0)
        arguments.push_back(option->get_name());
      else
        arguments.push_back(option->get_name() + "=" + value);
    }
  }
  return arguments;
}

MeshOptions optionsFrom(std::vector<std::string> arguments) {
  CLI::App command;
  MeshOptions options;
  declareMeshOptions(command, options);
  std::ranges::reverse(arguments);  // as CLI11 takes them
  try {
    command.parse(arguments);
  } catch (const CLI::ParseError& error) {
    throw InputError(error.what());
  }
  return options;
}

bool MeshRequest::asksByNumber() const {
  const auto isByNumber = [](const geometry::LayerRequest& layers) {
    return !layers.edges.empty() || !layers.faces.empty();
  };
  return !options.faces.empty() || !options.sizes.faceSizes.empty() ||
         !options.sizes.edgeSizes.empty() || !options.sizes.chords.faces.empty() ||
         !options.edgePoints.empty() || !periodic.pairs.empty() ||
         !merge.request.keptEdges.empty() || std::ranges::any_of(options.layers, isByNumber);
}

MeshRequest checkedRequest(const MeshOptions& options) {
  if (!options.format.empty())
    throw UsageError("--format is for a model from standard input; give - for it");
  MeshRequest request;
  request.model = options.model;
  request.options.sizes = checkedSizes(options.sizes);
  if (!options.faces.empty()) {
    FaceList faces = parseFaces("--faces", options.faces);
    request.options.faces = std::move(faces.ids);
    request.options.faceNames = std::move(faces.names);
  }
  if (options.threads < 0 || options.threads > 4096) {
    throw UsageError(fmt::format("--threads {}: give a number from 1 to 4096, or 0 for all cores",
                                 options.threads));
  }
  request.options.threads = options.threads;
  request.options.maxMemory = static_cast<double>(options.maxMemory);
  request.options.coarsen = options.coarsen;
  if (options.order != 1 && options.order != 2)
    throw UsageError(fmt::format("--order {}: elements can have order 1 or 2", options.order));
  request.options.order = options.order;
  request.quiet = options.quiet;
  request.ruleLoading = {options.quiet, options.unchecked, options.plugins};
  request.options.optimize = !options.rawFront;
  request.options.quads = checkedQuads(options);
  request.options.evenLoops = request.options.quads.onlyQuads;
  request.options.strictRules = options.strictRules;
  request.options.fewest = options.sizes.fewest;
  if (options.sizes.fewest && (options.order != 1 || request.options.quads.onlyQuads))
    throw UsageError("--fewest is for triangles of order 1");
  request.options.layers = checkedLayers(options.layers);
  if (options.sizes.fewest && !options.layers.empty())
    throw UsageError("--fewest cannot be combined with --layers");
  request.report = options.report;
  request.stuckTests = options.stuckTests;
  request.trace = options.trace;
  if (options.statistics && options.report.empty())
    throw UsageError("--statistics needs --report, which holds them");
  request.statistics = options.statistics;
  if (!options.traceFaces.empty()) {
    if (options.trace.empty()) throw UsageError("--trace-faces needs --trace");
    FaceList faces = parseFaces("--trace-faces", options.traceFaces);
    request.traceFaces = std::move(faces.ids);
    request.traceNames = std::move(faces.names);
  }
  request.outputs.assign(options.outputs.begin(), options.outputs.end());
  if (request.kind() != ModelKind::Planar && options.keepBoundary)
    throw UsageError("--keep-boundary is for " + formatNames(ModelKind::Planar, "and") +
                     " files; for other models use --boundary FILE");
  if (!options.featureAngle.empty()) {
    if (request.kind() != ModelKind::Faceted)
      throw UsageError("--feature-angle is for " + formatNames(ModelKind::Faceted, "and") +
                       " files");
    request.options.featureAngle =
        parsePositive("--feature-angle", options.featureAngle, "the angle in degrees");
    if (request.options.featureAngle >= 180)
      throw UsageError(
          fmt::format("--feature-angle {}: give an angle below 180 degrees", options.featureAngle));
  }
  request.options.keepBoundary = options.keepBoundary;
  if (options.edges) request.fileOptions.lines = geometry::LinesAlong::AllEdges;
  request.fileOptions.compress = options.compress;
  request.scale = checkedScale(options.scale, request.kind());
  if (!options.groups.empty()) request.fileOptions.groups = checkedGroups(options.groups);
  if (!options.chart.empty()) request.options.chart = checkedChart(options, request);
  if (options.heal && request.kind() != ModelKind::Cad) refuseHealing();
  request.heal = options.heal;
  request.healTolerance = checkedHealTolerance(options.heal, options.healTolerance);
  request.imprint = checkedImprint(options.imprint, request.kind());
  request.periodic = checkedPeriodic(options.periodic, request.kind());
  if (request.periodic.areAsked() && (options.sizes.fewest || !options.faces.empty()))
    throw UsageError("--periodic cannot be combined with --fewest and --faces");
  request.merge = checkedMerge(options.merge, request.kind(), options.sizes.fewest);
  checkOutputs(request);
  checkReadable(request.model);
  if (!options.boundary.empty())
    request.options.edgePoints = geometry::readEdgePoints(options.boundary);
  if (!options.points.empty()) {
    if (request.kind() == ModelKind::Faceted)
      throw UsageError("--points is for CAD models and planar domains");
    request.inside = geometry::readInsideFaces(options.points);
  }
  const bool isForQuads = request.options.quads.onlyQuads;
  const char* usual = isForQuads ? "quad/classic.af2" : "tri/even.af2";
  request.rules = findRuleFile(options.rules.empty() ? usual : options.rules);
  return request;
}

}  // namespace af2::cli
