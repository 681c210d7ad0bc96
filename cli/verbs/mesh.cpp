// af2 mesh
#include <filesystem>
#include <memory>

#include "cli/meshing/mesh_and_report.h"
#include "cli/meshing/standard_input.h"
#include "cli/meshing/stream_request.h"
#include "cli/program/interrupt.h"
#include "cli/program/supervisor.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"

namespace af2::cli {
namespace {

int meshUntilInterrupted(const MeshRequest& request, RunLog* log, const GivenUp& givenUp) {
  Interrupt interrupt;
  if (!log) interrupt.token();  // no supervisor ends a run that reads and is asked twice to stop
  return meshAndReport(request, {[&] { return interrupt.token(); }, log, &givenUp, {}});
}

/// CAD models are meshed in a supervised process, because OpenCASCADE may crash or hang on them or
/// on repairing them. Other models have no time limit.
int meshSafely(const MeshRequest& request) {
  if (request.kind() != ModelKind::Cad) return meshUntilInterrupted(request, nullptr, {});
  RunLimits limits;
  limits.first = secondsToRead(std::filesystem::file_size(request.model));
  if (request.imprint.isAsked) limits.first += 2 * kImprintSeconds;
  const auto run = [&](const MeshRequest& asked) {
    return supervise(limits, [&](RunLog& log, const GivenUp& givenUp) {
      return meshUntilInterrupted(asked, &log, givenUp);
    });
  };
  try {
    return run(request);
  } catch (const RunEnded& end) {
    if (request.asksByNumber() || (!request.heal && !request.imprint.isAsked)) throw;
    // What was done last is the likeliest cause.
    MeshRequest less = request;
    if (request.imprint.isAsked) {
      less.imprint = {};
      less.imprint.end = end.cause;
      return meshSafely(less);
    }
    less.heal = false;
    less.healingEnd = end.cause;
    return run(less);
  }
}

/// Writes a report even if the model is unusable: programs that run many models read only that.
int meshOrReportWhyNot(const MeshRequest& request) {
  try {
    return meshSafely(request);
  } catch (const std::exception& error) {
    geometry::RunReport report;
    report.reason = error.what();
    writeReportIfAsked(request, report, {});
    throw;
  }
}

/// What came through standard input, if the model does; the options then name a file that has it.
std::unique_ptr<TemporaryFile> takenInput(MeshOptions& options) {
  if (!isStandardInput(options.model)) return nullptr;
  if (!options.trace.empty())
    throw UsageError("--trace needs a model in a file, which is read again for the trace");
  auto input = takeStandardInput(options.format);
  options.model = input->path().string();
  options.format.clear();
  return input;
}

}  // namespace

Action declareMesh(CLI::App& command) {
  const auto options = std::make_shared<MeshOptions>();
  declareMeshOptions(command, *options);
  return [options, &command] {
    const std::unique_ptr<TemporaryFile> input = takenInput(*options);
    MeshRequest request = checkedRequest(*options);
    request.arguments = argumentsOf(command);
    request.options.spool = checkedStream(options->stream, request);
    return meshOrReportWhyNot(request);
  };
}

}  // namespace af2::cli
