#include "cli/meshing/mesh_and_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "cli/meshing/contact_texts.h"
#include "cli/meshing/mesh_run.h"
#include "cli/meshing/mesh_summary.h"
#include "cli/meshing/model_runs.h"
#include "cli/meshing/rule_statistics.h"
#include "cli/meshing/run_recorders.h"
#include "cli/meshing/stuck_causes.h"
#include "cli/meshing/stuck_tests.h"
#include "cli/program/exit_code.h"
#include "cli/program/usage_error.h"
#include "cli/rules/rule_loading.h"
#include "cli/rules/rule_texts.h"
#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "geometry/io/mesh_files.h"
#include "geometry/mesh/element_scores.h"
#include "geometry/mesh/quality.h"
#include "geometry/mesh/scaled_mesh.h"

namespace af2::cli {

using geometry::ModelMesh;
using geometry::RunReport;
using geometry::RunStatus;

namespace {

/// Only if a file holds them: they take time.
void scoreElements(const MeshRequest& request, const RuleSet& rules, ModelMesh& mesh) {
  if (std::ranges::any_of(request.outputs, [](const auto& output) {
        return geometry::meshFormatOf(output).holdsScores;
      }))
    geometry::scoreElements(mesh, rules.definition(), request.options.threads);
}

/// Writes one file after another. A file that cannot be written does not affect the others.
class Files {
 public:
  template <class Write>
  void write(Write write) {
    try {
      write();
    } catch (const InputError& error) {
      faults_.emplace_back(error.what());
    }
  }
  const std::vector<std::string>& faults() const { return faults_; }

 private:
  std::vector<std::string> faults_;
};

void writeOutputs(const MeshRequest& request, const RuleSet& rules, ModelMesh& mesh, Files& files) {
  if (elementCount(mesh) == 0) return;  // an empty file would look like a result
  const Stopwatch writing;
  scoreElements(request, rules, mesh);
  const auto write = [&](const ModelMesh& written) {
    for (const auto& output : request.outputs)
      files.write([&] { geometry::writeMesh(written, output, request.fileOptions); });
  };
  if (request.scale.factor == 1)
    write(mesh);
  else if (!request.outputs.empty())
    write(geometry::scaledMesh(mesh, request.scale.factor));
  mesh.seconds.write = writing.seconds();
}

ExitCode exitCodeOf(RunStatus status) {
  switch (status) {
    case RunStatus::Complete:
      return kComplete;
    case RunStatus::Cancelled:
      return kCancelled;
    case RunStatus::Partial:
    case RunStatus::Failed:
      return kPartial;
  }
  return kPartial;
}

void printResult(const MeshRequest& request, const RunReport& report, const ModelMesh& mesh) {
  std::string text = failureText(mesh);
  if (!report.reason.empty()) text += fmt::format("af2: {}\n", report.reason);
  if (report.status == RunStatus::Cancelled) text += "af2: stopped before the mesh was complete\n";
  if (elementCount(mesh) == 0 && !request.outputs.empty())
    text += "af2: the mesh is empty, so no file was written\n";
  if (!mesh.straightened.empty())
    text += fmt::format("af2: {} elements of second order kept straight sides (see --report)\n",
                        mesh.straightened.size());
  text += withoutRuleText(mesh);
  if (!request.quiet && request.stuckTests.empty()) text += stuckText(mesh);
  std::fputs(text.c_str(), stderr);  // does not throw if stderr is closed
  if (!request.quiet)
    fmt::print("{}{}{}{}{}{}{}{}", unitText(mesh), notesText(mesh.notes), healingText(mesh.healing),
               imprintText(mesh.imprinting), mergeText(mesh.merging), contactWarning(mesh.contacts),
               layersText(mesh), summaryText(mesh, report.quality));
}

/// A complete run is none any more.
void addReason(RunReport& report, const std::string& reason) {
  report.reason += (report.reason.empty() ? "" : "; ") + reason;
  if (report.status == RunStatus::Complete) report.status = RunStatus::Partial;
}

/// The status of a run, from its faces and from the checks of the whole mesh.
RunReport reportOf(const ModelMesh& mesh, bool strictRules) {
  RunReport report;
  report.status = statusOf(mesh);
  for (const std::string& finding : mesh.findings) addReason(report, finding);
  if (const std::string triangles = trianglesText(mesh); !triangles.empty())
    addReason(report, triangles);
  if (strictRules && elementsWithoutRule(mesh).total() > 0)
    addReason(report, "elements were made without a rule, which --strict-rules does not accept");
  return report;
}

}  // namespace

void writeReportIfAsked(const MeshRequest& request, const RunReport& report,
                        const ModelMesh& mesh) {
  if (!request.report.empty()) geometry::writeReport(report, mesh, request.report);
}

int meshAndReport(const MeshRequest& request, const RunWatch& watch) {
  const dsl::LoadedRules loaded = loadRuleSet(request.rules, request.ruleLoading);
  if (request.options.quads.onlyQuads && !loaded.rules->makesQuads())
    throw UsageError(fmt::format(
        "--elements quad: the rules '{}' make no quadrilaterals; leave out -r, or use quad/classic",
        request.rules.string()));
  RunRecorders recorders(request, *loaded.rules);
  const RunControl control{!request.quiet, watch.stop,    recorders.observers(),
                           watch.log,      watch.givenUp, recorders.nameListener()};
  ModelMesh mesh = runMesh(request, loaded.rules, control);
  mesh.name = request.model.filename().string();
  mesh.ruleTexts = ruleTextsOf(loaded);
  if (watch.meshed) watch.meshed(mesh);
  RunReport report = reportOf(mesh, request.options.strictRules);
  Files files;
  // Writing files and measuring quality run in parallel, unless each would load faces from disk.
  const auto write = [&] { writeOutputs(request, *loaded.rules, mesh, files); };
  const auto measure = [&] {
    // Only where it is told, since it takes long for a large mesh.
    if (!request.quiet || !request.report.empty()) report.quality = measureQuality(mesh, 0);
  };
  withThreads(request.options.threads, [&] {
    if (mesh.spooled) {
      write();
      measure();
    } else {
      forEachInParallel(2, 0, [&](std::size_t task) { task == 0 ? write() : measure(); });
    }
  });
  for (const std::string& fault : files.faults()) addReason(report, fault);
  if (!request.report.empty()) report.sections["stuck"] = stuckJson(mesh);
  if (request.statistics)
    report.sections["statistics"] =
        toJson(*loaded.rules, statisticsOf(*loaded.rules, mesh, recorders.counters()));
  const std::size_t told = files.faults().size();
  files.write([&] { writeReportIfAsked(request, report, mesh); });
  if (!request.trace.empty()) files.write([&] { recorders.writeTrace(); });
  if (!request.stuckTests.empty())
    files.write([&] { writeStuckTests(request, *loaded.rules, mesh); });
  for (std::size_t i = told; i < files.faults().size(); ++i) addReason(report, files.faults()[i]);
  printResult(request, report, mesh);
  return files.faults().empty() ? exitCodeOf(report.status) : kUnusable;
}

}  // namespace af2::cli
