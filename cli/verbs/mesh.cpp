// af2 mesh
#include <fmt/core.h>

#include <cstdio>
#include <filesystem>

#include "cli/meshing/mesh_run.h"
#include "cli/meshing/mesh_summary.h"
#include "cli/meshing/model_runs.h"
#include "cli/program/exit_code.h"
#include "cli/program/interrupt.h"
#include "cli/program/supervisor.h"
#include "cli/program/verbs.h"
#include "cli/rules/rule_loading.h"
#include "engine/base/error.h"
#include "geometry/base/parallel.h"
#include "geometry/io/mesh_files.h"
#include "geometry/io/output_file.h"
#include "geometry/io/report.h"
#include "geometry/mesh/quality.h"

namespace af2::cli {
namespace {

using geometry::ModelMesh;
using geometry::RunReport;
using geometry::RunStatus;

void writeOutputs(const MeshRequest& request, ModelMesh& mesh) {
  if (mesh.elements.empty()) return;  // an empty file would look like a result
  const Stopwatch writing;
  for (const auto& output : request.outputs) geometry::writeMesh(mesh, output, request.lines);
  mesh.seconds.write = writing.seconds();
}

void writeReportIfAsked(const MeshRequest& request, const RunReport& report,
                        const ModelMesh& mesh) {
  if (request.report.empty()) return;
  geometry::OutputFile file(request.report);
  geometry::writeReport(report, mesh, file);
  file.commit();
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

void tell(const MeshRequest& request, const RunReport& report, const ModelMesh& mesh) {
  std::string text = failureText(mesh);
  if (!report.reason.empty()) text += fmt::format("af2: {}\n", report.reason);
  if (report.status == RunStatus::Cancelled) text += "af2: stopped before the end\n";
  if (mesh.elements.empty() && !request.outputs.empty())
    text += "af2: there is no mesh, so no file was written\n";
  if (!mesh.straightened.empty())
    text += fmt::format("af2: {} elements of second order kept straight sides (see --report)\n",
                        mesh.straightened.size());
  std::fputs(text.c_str(), stderr);  // does not throw if nobody listens
  if (!request.quiet)
    fmt::print("{}{}{}{}", unitText(mesh), notesText(mesh.notes), healingText(mesh.healing),
               summaryText(mesh, report.quality));
}

/// The status of a run, by its faces and by what the checks of the whole found.
RunReport reportOf(const ModelMesh& mesh) {
  RunReport report;
  for (const std::string& finding : mesh.findings)
    report.reason += (report.reason.empty() ? "" : "; ") + finding;
  report.status = statusOf(mesh);
  if (!report.reason.empty() && report.status == RunStatus::Complete) {
    report.status = RunStatus::Partial;
  }
  return report;
}

int meshAndTell(const MeshRequest& request, RunLog* log, const GivenUp& givenUp) {
  const Interrupt interrupt;
  ModelMesh mesh = runMesh(request, loadRuleSet(request.rules),
                           {!request.quiet, interrupt.token(), log, &givenUp});
  RunReport report = reportOf(mesh);
  // Files do not wait for the figures about the mesh.
  geometry::forEachInParallel(2, request.options.threads, [&](std::size_t task) {
    if (task == 0)
      writeOutputs(request, mesh);
    else
      report.quality = measureQuality(mesh, 0);
  });
  writeReportIfAsked(request, report, mesh);
  tell(request, report, mesh);
  return exitCodeOf(report.status);
}

/// CAD models go through OpenCASCADE, which may crash or hang on them, or on repairing them; what
/// else there is takes as long as it takes.
int meshSafely(const MeshRequest& request) {
  if (request.kind() != ModelKind::Cad) return meshAndTell(request, nullptr, {});
  RunLimits limits;
  limits.first = secondsToRead(std::filesystem::file_size(request.model));
  const auto run = [&](const MeshRequest& asked) {
    return supervise(limits, [&](RunLog& log, const GivenUp& givenUp) {
      return meshAndTell(asked, &log, givenUp);
    });
  };
  try {
    return run(request);
  } catch (const RunEnded& end) {
    if (!request.heal || request.asksByNumber()) throw;
    MeshRequest unhealed = request;
    unhealed.heal = false;
    unhealed.healingEnd = end.cause;
    return run(unhealed);
  }
}

/// A report is written even if the model is unusable: whoever runs many models reads only that.
int meshOrReportWhyNot(const MeshRequest& request) {
  try {
    return meshSafely(request);
  } catch (const std::exception& error) {
    RunReport report;
    report.reason = error.what();
    writeReportIfAsked(request, report, {});
    throw;
  }
}

}  // namespace

Action declareMesh(CLI::App& command) {
  const auto options = std::make_shared<MeshOptions>();
  declareMeshOptions(command, *options);
  return [options] { return meshOrReportWhyNot(checkedRequest(*options)); };
}

}  // namespace af2::cli
