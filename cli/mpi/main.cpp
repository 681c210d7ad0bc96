// The program af2-mpi: `af2 mesh` in all processes of an MPI run.
#include <fmt/core.h>
#include <mpi.h>
#include <sched.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <stop_token>
#include <thread>

#include "cli/meshing/mesh_and_report.h"
#include "cli/meshing/mesh_run.h"
#include "cli/meshing/stream_request.h"
#include "cli/mpi/model_file.h"
#include "cli/program/command_faults.h"
#include "cli/program/exit_code.h"
#include "cli/program/freed_memory.h"
#include "cli/program/interrupt.h"
#include "cli/program/usage_error.h"
#include "cli/rules/rule_loading.h"
#include "geometry/mesh/scaled_mesh.h"
#include "geometry/mpi/crew/process.h"
#include "geometry/mpi/crew/topics.h"
#include "geometry/mpi/crew/workers.h"
#include "geometry/mpi/partition/part_files.h"

namespace af2::mpi {
namespace {

using namespace cli;
using geometry::ModelMesh;

void complain(const std::string& message) {
  std::fputs(fmt::format("af2-mpi: error: {}\n", message).c_str(), stderr);
}

int processesOfThisMachine() {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int count = 1;
  MPI_Comm_size(machine, &count);
  MPI_Comm_free(&machine);
  return count;
}

/// The processors that this process may use, shared with the others of the machine unless it has
/// been given some of its own.
int usualThreads() {
  const int processes = processesOfThisMachine();
  cpu_set_t own;
  const long all = ::sysconf(_SC_NPROCESSORS_ONLN);
  const int some = ::sched_getaffinity(0, sizeof own, &own) == 0 ? CPU_COUNT(&own) : 1;
  return std::max(1, some < all ? some : some / processes);
}

void refuseWhatNeedsOneProcess(const MeshOptions& options) {
  if (options.coarsen)
    throw UsageError("--coarsen: all processes must know the sizes beforehand; use af2 mesh");
  if (!options.trace.empty() || options.statistics)
    throw UsageError(
        fmt::format("{}: the decisions of all processes are not collected; use af2 mesh",
                    options.trace.empty() ? "--statistics" : "--trace"));
}

/// The options of af2-mpi: those of `af2 mesh`, and what only several processes can do.
struct Options {
  MeshOptions mesh;
  std::string parts;
};

/// Where nothing speaks against it, faces stay with the processes that have meshed them: on disk if
/// that is asked for.
geometry::SpoolRequest keptFaces(bool areOnDisk, const MeshRequest& request, int processes) {
  using Request = geometry::SpoolRequest;
  Request kept = checkedStream(areOnDisk, request);
  if (kept.when != Request::When::IfNeeded) return kept;
  kept.when = processes > 1 ? Request::When::Always : Request::When::Never;
  kept.where = Request::Where::Memory;
  return kept;
}

/// Gives each process its part of the mesh, which writes it. No file appears unless all can be
/// written.
void writeParts(Crew& crew, const ModelMesh& mesh, const MeshRequest& request,
                const std::string& file) {
  if (elementCount(mesh) == 0 || file.empty()) return;
  const double factor = request.scale.factor;
  const auto partOf = [&](const ModelMesh& whole) {
    return distribute(crew, whole, request.fileOptions.lines);
  };
  const PartFiles files =
      writePart(factor == 1 ? partOf(mesh) : partOf(scaledMesh(mesh, factor)), file);
  const int others = crew.process().post().ranks() - 1;
  crew.process().waitForDone(others);
  crew.process().orderAll(Order::Commit, {});
  for (const auto& part : files) part->commit();
  crew.process().waitForDone(others);
}

void writeOwnPart(Crew& crew, const std::string& file) {
  const PartFiles files = writePart(distribute(crew, {}, {}), file);
  crew.process().done();
  crew.process().waitFor(Order::Commit);
  for (const auto& part : files) part->commit();
  crew.process().done();
}

int lead(Crew& crew, const Options& given, int threads) {
  const MeshOptions& options = given.mesh;
  refuseWhatNeedsOneProcess(options);
  MeshRequest request = checkedRequest(options);
  if (!given.parts.empty()) checkPartsFile(given.parts);
  // Before the others do so, and say the same about errors.
  loadRuleSet(request.rules, {true, request.ruleLoading.isUnchecked, request.ruleLoading.plugins});
  sendModel(crew.process(), request.model);
  request.options.threads = threads;
  request.options.crew = crew.faces();
  request.options.spool = keptFaces(options.stream, request, crew.process().post().ranks());
  RunWatch watch;
  watch.meshed = [&](const ModelMesh& mesh) { writeParts(crew, mesh, request, given.parts); };
  try {
    return meshAndReport(request, watch);
  } catch (const std::exception& error) {
    geometry::RunReport report;
    report.reason = reasonOf(error);
    writeReportIfAsked(request, report, {});
    throw;
  }
}

/// Meshes faces for the leader, which alone says and writes something.
int follow(Crew& crew, const Options& given, int threads) {
  MeshOptions options = given.mesh;
  const cli::TemporaryFile model = receiveModel(crew.process());
  options.model = model.path().string();
  options.outputs.clear();
  options.report.clear();
  options.stuckTests.clear();
  options.groups.clear();
  options.compress = false;
  options.quiet = true;
  MeshRequest request = checkedRequest(options);
  request.options.threads = threads;
  request.options.crew = crew.faces();
  request.options.maxMemory = std::numeric_limits<double>::infinity();  // the leader decides
  // The folder of the output may be one of the machine of the leader.
  request.options.spool.folder = std::filesystem::temp_directory_path();
  RunControl control;
  control.showProgress = false;
  control.names = [&](auto, auto) { model.remove(); };  // it has been read
  runMesh(request, loadRuleSet(request.rules, request.ruleLoading).rules, control);
  if (!given.parts.empty()) writeOwnPart(crew, given.parts);
  return crew.process().waitForStop();
}

int explain(const CLI::App& program, const CLI::ParseError& error, bool isFirst) {
  if (const auto* success = dynamic_cast<const CLI::Success*>(&error))
    return isFirst ? program.exit(*success) : 0;
  if (isFirst) complain(faultOf(program, error) + "\ntry: af2-mpi --help");
  return kUsage;
}

/// What went wrong, and the exit code.
std::pair<std::string, int> faultOf(const std::exception& error) {
  if (dynamic_cast<const UsageError*>(&error))
    return {error.what() + std::string("\ntry: af2-mpi --help"), kUsage};
  if (dynamic_cast<const std::bad_alloc*>(&error)) return {reasonOf(error), kUnusable};
  if (dynamic_cast<const InternalError*>(&error))
    return {fmt::format("this is a defect of AF2, please report it: {}", error.what()), kUnusable};
  return {error.what(), kUnusable};
}

int runLeader(Crew& crew, const Options& options, int threads) {
  int code = kUnusable;
  try {
    code = lead(crew, options, threads);
  } catch (const std::exception& error) {
    std::string reason;
    std::tie(reason, code) = faultOf(error);
    complain(reason);
  }
  crew.process().stop("the run was stopped", code);
  return code;
}

int runFollower(Crew& crew, const Options& options, int threads) {
  try {
    return follow(crew, options, threads);
  } catch (const RunStopped& stop) {
    return stop.exitCode;
  } catch (const std::exception& error) {
    crew.process().giveUp(faultOf(error).first);
    return crew.process().waitForStop();
  }
}

/// Where a process dies, mpirun ends the others by a signal.
void endAtOnce(bool isFirst) {
  if (isFirst)
    std::fputs(
        "af2-mpi: error: the run was ended by a signal, as it is when a process of it dies; no "
        "file "
        "was left incomplete\n",
        stderr);
  std::_Exit(kCancelled);
}

int run(int count, char** arguments, Interrupt& interrupt) {
  CLI::App program{"Meshes a model in all processes of an MPI run: mpirun -n 4 af2-mpi MODEL ...",
                   "af2-mpi"};
  Options options;
  declareMeshOptions(program, options.mesh);
  program.add_option("--parts", options.parts,
                     "Write the mesh in parts, one by each process, to this .pvtu or .msh file");
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const std::stop_callback ended(interrupt.token(), [&] { endAtOnce(rank == 0); });
  try {
    program.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    return explain(program, error, rank == 0);
  }
  // In all processes, whether they need it or not.
  const int usual = usualThreads(),
            threads = options.mesh.threads > 0 ? options.mesh.threads : usual;
  Crew crew(MPI_COMM_WORLD, threads);
  return rank == 0 ? runLeader(crew, options, threads) : runFollower(crew, options, threads);
}

}  // namespace
}  // namespace af2::mpi

int main(int count, char** arguments) {
  af2::cli::keepFreedMemory();
  af2::cli::Interrupt interrupt;  // before other threads start
  int level = 0;
  MPI_Init_thread(&count, &arguments, MPI_THREAD_SERIALIZED, &level);
  const int code = af2::mpi::run(count, arguments, interrupt);
  std::fflush(nullptr);
  MPI_Finalize();
  std::_Exit(code);
}
