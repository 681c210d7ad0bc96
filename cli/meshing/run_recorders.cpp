#include "cli/meshing/run_recorders.h"

#include <filesystem>

#include "geometry/meshing/part_sizes.h"

namespace af2::cli {

void ObserverPair::frontBegun(const FrontInput& input) {
  first_.frontBegun(input);
  second_.frontBegun(input);
}

void ObserverPair::stepTaken(const StepReport& step) {
  first_.stepTaken(step);
  second_.stepTaken(step);
}

void ObserverPair::meshGrown(const StepReport& step, const Mesh& mesh) {
  first_.meshGrown(step, mesh);
  second_.meshGrown(step, mesh);
}

void ObserverPair::frontActed(const FrontAct& act, const Mesh& mesh) {
  first_.frontActed(act, mesh);
  second_.frontActed(act, mesh);
}

bool ObserverPair::wantsRefusals() const {
  return first_.wantsRefusals() || second_.wantsRefusals();
}

void ObserverPair::rulesRefused(const StepReport& step, std::span<const RuleRefusal> refusals) {
  if (first_.wantsRefusals()) first_.rulesRefused(step, refusals);
  if (second_.wantsRefusals()) second_.rulesRefused(step, refusals);
}

bool ObserverPair::wantsFrontAround(const StepReport& step) const {
  return first_.wantsFrontAround(step) || second_.wantsFrontAround(step);
}

void ObserverPair::frontAround(const StepReport& step, const LocalFront& front) {
  if (first_.wantsFrontAround(step)) first_.frontAround(step, front);
  if (second_.wantsFrontAround(step)) second_.frontAround(step, front);
}

void ObserverPair::frontEnded(std::size_t edgesLeft) {
  first_.frontEnded(edgesLeft);
  second_.frontEnded(edgesLeft);
}

FinishObserver* ObserverPair::finishing() {
  FinishObserver* const first = first_.finishing();
  return first ? first : second_.finishing();
}

RunRecorders::RunRecorders(const MeshRequest& request, const RuleSet& rules)
    : request_(request),
      rules_(rules),
      trace_(request.traceFaces),
      counters_(rules.rules().size()) {}

std::function<AF2MeshingObserver*(int face)> RunRecorders::observers() {
  if (request_.trace.empty() && !request_.statistics) return {};
  return [this](int face) { return observerOf(face); };
}

std::function<void(std::span<const std::string>, std::span<const geometry::FaceGroup>)>
RunRecorders::nameListener() {
  if (request_.traceNames.empty()) return {};
  return [this](std::span<const std::string> names, std::span<const geometry::FaceGroup> groups) {
    trace_.restrictTo(
        geometry::withFacesCalled(request_.traceFaces, request_.traceNames, names, groups));
  };
}

AF2MeshingObserver* RunRecorders::observerOf(int face) {
  AF2MeshingObserver* const trace = request_.trace.empty() ? nullptr : trace_.observerOf(face);
  AF2MeshingObserver* const counter = request_.statistics ? counters_.observerOfFace() : nullptr;
  if (!trace || !counter) return trace ? trace : counter;
  const std::lock_guard lock(mutex_);
  return &pairs_.emplace_back(*trace, *counter);
}

void RunRecorders::writeTrace() {
  Trace trace;
  trace.arguments = request_.arguments;
  trace.directory = std::filesystem::current_path();
  for (const AF2Rule& rule : rules_.rules()) trace.ruleNames.push_back(rule.name());
  for (const auto& file : {request_.model, request_.rules})
    trace.checksums[file.string()] = checksumOf(file);
  trace.faces = trace_.take();
  cli::writeTrace(trace, request_.trace);
}

}  // namespace af2::cli
