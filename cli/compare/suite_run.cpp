#include "cli/compare/suite_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <mutex>

#include "cli/program/progress_bar.h"
#include "engine/base/error.h"
#include "engine/base/parallel.h"

namespace af2::cli {
namespace {

using geometry::FaceReport;

void takeMesh(geometry::ModelMesh mesh, bool isKept, CaseResult& result) {
  for (const FaceReport& face : mesh.faces) {
    result.failedFaces += face.status == geometry::FaceStatus::Failed;
    result.stuckFaces += !face.stuck.empty();
  }
  result.seconds = mesh.seconds.edges + mesh.seconds.surface + mesh.seconds.optimize;
  result.withoutRule = elementsWithoutRule(mesh).total();
  result.hasMesh = !mesh.elements.empty();
  if (!result.hasMesh) {
    result.failedFaces = std::max<std::size_t>(result.failedFaces, 1);
    return;
  }
  result.measures = geometry::measureMesh(mesh);
  if (isKept) result.drawn = std::move(mesh);
}

CaseResult runCase(const SuiteCase& one, const ComparedRules& rules, MeshStage stage,
                   const SuiteControl& control) {
  CaseResult result;
  geometry::MeshingOptions options;
  options.threads = one.isAlone && !control.isTimed ? 0 : 1;
  options.stop = control.stop;
  options.strictRules = control.strictRules;
  options.optimize = stage == MeshStage::Finished;
  options.evenLoops = control.onlyQuads;
  options.quads.onlyQuads = control.onlyQuads && options.optimize;
  try {
    takeMesh(one.mesh(rules, options), control.keepsMeshes && one.isDrawn, result);
  } catch (const InputError& error) {
    result.fault = error.what();
  } catch (const GeometryError& error) {
    result.fault = error.what();
  }
  if (!result.fault.empty()) result.failedFaces = 1;
  return result;
}

}  // namespace

const char* toString(MeshStage stage) { return stage == MeshStage::Raw ? "raw" : "finished"; }

SuiteResult runSuite(const Suite& suite, const std::array<ComparedRules, 2>& sets,
                     const SuiteControl& control) {
  SuiteResult result;
  result.cases.resize(suite.cases.size());
  for (const SuiteCase& one : suite.cases) result.names.push_back(one.name);
  ProgressBar bar(true);
  std::mutex mutex;
  std::size_t done = 0;
  const std::size_t runs = 4 * suite.cases.size();
  const auto run = [&](std::size_t number, bool isAlone) {
    const std::size_t i = number / 4, stage = number % 4 / 2, set = number % 2;
    if (suite.cases[i].isAlone != isAlone || control.stop.stop_requested()) return;
    CaseResult one = runCase(suite.cases[i], sets[set], kMeshStages[stage], control);
    const std::lock_guard lock(mutex);
    result.cases[i][stage][set] = std::move(one);
    bar.show("comparing", static_cast<double>(++done) / static_cast<double>(runs),
             fmt::format("{}/{} meshes", done, runs));
  };
  for (std::size_t number = 0; number < runs; ++number) run(number, true);
  forEachInParallel(runs, control.isTimed ? 1 : 0, [&](std::size_t number) { run(number, false); });
  return result;
}

}  // namespace af2::cli
