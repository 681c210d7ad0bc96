#include "cli/meshing/replay.h"

#include <fmt/core.h>

#include "cli/meshing/mesh_request.h"
#include "cli/meshing/mesh_run.h"
#include "cli/program/interrupt.h"
#include "cli/rules/rule_loading.h"
#include "cli/rules/rule_texts.h"
#include "engine/base/error.h"

namespace af2::cli {
namespace {

namespace fs = std::filesystem;

/// Paths of the arguments are relative to the folder in which the run was started.
class InDirectory {
 public:
  explicit InDirectory(const fs::path& directory) : before_(fs::current_path()) {
    std::error_code failed;
    fs::current_path(directory, failed);
    if (failed)
      throw InputError(fmt::format("the run was started in '{}', which cannot be entered: {}",
                                   directory.string(), failed.message()));
  }
  ~InDirectory() {
    std::error_code ignored;
    fs::current_path(before_, ignored);
  }
  InDirectory(const InDirectory&) = delete;
  InDirectory& operator=(const InDirectory&) = delete;

 private:
  fs::path before_;
};

MeshRequest requestOf(const Trace& trace) {
  MeshRequest request = checkedRequest(optionsFrom(trace.arguments));
  request.quiet = true;
  request.ruleLoading.isQuiet = request.ruleLoading.isUnchecked = true;
  return request;
}

}  // namespace

Replay::Replay(const Trace& trace) : trace_(trace) {
  const InDirectory inDirectory(trace.directory);
  for (const auto& [file, sum] : trace.checksums)
    if (checksumOf(file) != sum)
      throw InputError(fmt::format(
          "'{}' has changed since the trace was made; make the trace again with 'af2 mesh ... "
          "--trace FILE'",
          file));
  const MeshRequest request = requestOf(trace);
  ruleFile_ = fs::absolute(request.rules).lexically_normal();
  const dsl::LoadedRules loaded = loadRuleSet(request.rules, request.ruleLoading);
  rules_ = loaded.rules;
  ruleTexts_ = ruleTextsOf(loaded);
}

geometry::ModelMesh Replay::run(
    const std::function<AF2MeshingObserver*(int face)>& observer) const {
  const InDirectory inDirectory(trace_.directory);
  Interrupt interrupt;
  const MeshRequest request = requestOf(trace_);
  return runMesh(request, rules_,
                 {false, [stop = interrupt.token()] { return stop; }, observer, nullptr, nullptr});
}

}  // namespace af2::cli
