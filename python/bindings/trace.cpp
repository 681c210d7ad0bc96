#include "python/bindings/trace.h"

#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace af2::python {
namespace {

/// One step, with the reason for each rule that was not applied.
struct TracedStep {
  int face = 0;
  StepReport step;
  std::vector<std::pair<std::size_t, std::string>> refusals;
};

/// The observer of one face, or of a piece of it.
class Tracer final : public AF2MeshingObserver {
 public:
  Tracer(int face, std::shared_ptr<py::object> callable, std::shared_ptr<Call> call)
      : face_(face), callable_(std::move(callable)), call_(std::move(call)) {}

  bool wantsRefusals() const override { return true; }
  /// Follows each step.
  void rulesRefused(const StepReport& step, std::span<const RuleRefusal> refusals) override {
    TracedStep traced{face_, step, {}};
    for (const RuleRefusal& refusal : refusals)
      traced.refusals.emplace_back(refusal.rule, toString(refusal.reason));
    call_->back([&] { (*callable_)(std::move(traced)); });
  }

 private:
  int face_;
  std::shared_ptr<py::object> callable_;
  std::shared_ptr<Call> call_;
};

struct Tracers {
  std::mutex mutex;
  std::deque<Tracer> all;
};

py::tuple pointOf(const Point3& p) { return py::make_tuple(p.x, p.y, p.z); }

}  // namespace

std::function<AF2MeshingObserver*(int face)> tracersFor(py::object callable,
                                                        std::shared_ptr<Call> call) {
  return [tracers = std::make_shared<Tracers>(), function = shared(std::move(callable)),
          call = std::move(call)](int face) -> AF2MeshingObserver* {
    const std::lock_guard lock(tracers->mutex);
    return &tracers->all.emplace_back(face, function, call);
  };
}

void bindTrace(py::module_& module) {
  py::class_<TracedStep>(
      module, "Step",
      "One step of a front: face, start, end, level, applied, rule, score, elements, "
      "front_edges, refusals.")
      .def_readonly("face", &TracedStep::face)
      .def_property_readonly("start", [](const TracedStep& s) { return pointOf(s.step.fromPoint); })
      .def_property_readonly("end", [](const TracedStep& s) { return pointOf(s.step.toPoint); })
      .def_property_readonly("level", [](const TracedStep& s) { return s.step.level; })
      .def_property_readonly("applied", [](const TracedStep& s) { return s.step.applied; })
      .def_property_readonly("rule",
                             [](const TracedStep& s) -> std::optional<std::size_t> {
                               if (!s.step.applied) return std::nullopt;
                               return s.step.rule;
                             })
      .def_property_readonly("score", [](const TracedStep& s) { return s.step.score; })
      .def_property_readonly("elements", [](const TracedStep& s) { return s.step.elements; })
      .def_property_readonly("front_edges", [](const TracedStep& s) { return s.step.frontEdges; })
      .def_readonly("refusals", &TracedStep::refusals);
}

}  // namespace af2::python
