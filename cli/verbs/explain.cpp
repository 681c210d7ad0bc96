// af2 explain
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <limits>
#include <list>
#include <memory>
#include <mutex>
#include <optional>

#include "cli/meshing/replay.h"
#include "cli/program/exit_code.h"
#include "cli/program/text_files.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"
#include "cli/rules/match_arguments.h"
#include "cli/trace_view/edge_step.h"
#include "dsl/run/evaluate.h"
#include "dsl/run/explain.h"
#include "dsl/run/piece_text.h"
#include "engine/base/error.h"
#include "engine/base/place_text.h"

namespace af2::cli {
namespace {

struct ExplainOptions {
  std::string trace, at, edge, whyNot, extract, format = "pretty";
  int face = 0, step = 0, element = -1;
};

/// Which step is asked for: a number, or else the step whose base edge is nearest to a place.
struct Target {
  int face = 0;          ///< 0: any
  std::size_t step = 0;  ///< in the face, from 1; 0: by place
  Point3 place = {};
  /// Only steps that applied this rule; kNoRule: only steps that applied none. No value: all.
  std::optional<std::size_t> rule = {};
  static constexpr std::size_t kNoRule = std::numeric_limits<std::size_t>::max();

  bool accepts(const StepReport& taken) const {
    return !rule || (taken.applied ? *rule == taken.rule : *rule == kNoRule);
  }
};

/// A step of the run and the front around it.
struct FoundStep {
  int face = 0;
  std::size_t step = 0;
  double distance = 0;  ///< of the middle of the base edge from the place
  StepReport report;
  LocalFront around;
};

/// Watches one front after another of one face.
class Finder final : public AF2MeshingObserver {
 public:
  Finder(const Target& target, int face) : target_(target), face_(face) {}

  bool wantsFrontAround(const StepReport& step) const override {
    if (target_.step > 0) return step_ + 1 == target_.step;
    // Of the steps at one base edge, the last: it was tried at the highest level.
    return !found || distanceOf(step) <= found->distance;
  }
  void stepTaken(const StepReport&) override { ++step_; }
  void frontAround(const StepReport& step, const LocalFront& around) override {
    if (target_.accepts(step)) found = FoundStep{face_, step_, distanceOf(step), step, around};
  }

  std::optional<FoundStep> found;

 private:
  double distanceOf(const StepReport& step) const {
    return distance(0.5 * (step.fromPoint + step.toPoint), target_.place);
  }

  const Target& target_;
  int face_;
  std::size_t step_ = 0;  ///< steps of the face so far
};

/// The last step without a rule before a front ended with edges left.
std::optional<Target> firstStuckStep(const Trace& trace, int face) {
  for (const auto& [id, entries] : trace.faces) {
    if (face != 0 && id != face) continue;
    std::size_t step = 0, refused = 0;
    for (const TraceEntry& entry : entries) {
      step += entry.isStep();
      if (entry.kind == TraceEntry::Kind::Refused) refused = step;
      if (entry.kind == TraceEntry::Kind::End && entry.from > 0 && refused > 0)
        return Target{id, refused};
    }
  }
  return std::nullopt;
}

Target targetOf(const ExplainOptions& options, const Trace& trace) {
  if (options.face != 0 && !trace.faces.contains(options.face))
    throw UsageError(fmt::format("--face {}: the trace has no steps of this face", options.face));
  if (!options.at.empty()) return {options.face, 0, parsePoint3("--at", options.at)};
  if (options.step != 0) {
    int face = options.face;
    if (face == 0 && trace.faces.size() == 1) face = trace.faces.begin()->first;
    if (face == 0) throw UsageError("--step needs --face, because the trace has several faces");
    const auto steps = std::ranges::count_if(trace.faces.at(face), &TraceEntry::isStep);
    if (options.step < 1 || options.step > steps)
      throw UsageError(
          fmt::format("--step {}: face {} has steps 1 to {}", options.step, face, steps));
    return {face, static_cast<std::size_t>(options.step)};
  }
  if (!options.edge.empty()) return {};  // found by a replay
  if (const auto stuck = firstStuckStep(trace, options.face)) return *stuck;
  throw UsageError("no front got stuck in this run; name a step by --face and --step, or by --at");
}

/// The step that made an element is the one with its rule whose base edge is nearest. Where no rule
/// made it, the nearest step that applied none says why; where optimisation changed it, any step.
Target targetOf(int number, const Replay& replay) {
  const geometry::ModelMesh mesh = replay.run({});
  const auto index = static_cast<std::size_t>(number);
  if (index >= mesh.elements.size())
    throw UsageError(fmt::format("--element {}: the mesh has elements 0 to {}", number,
                                 static_cast<std::ptrdiff_t>(mesh.elements.size()) - 1));
  Target target;
  target.face = mesh.face[index];
  const Element& element = mesh.elements[index];
  for (const VertexId v : element.vertices())
    target.place = target.place + (1.0 / element.size()) * mesh.vertices[v.value];
  const ElementOrigin& origin = mesh.origins[index];
  if (origin.isChanged) return target;
  target.rule = origin.rule < replay.rules().rules().size() ? origin.rule : Target::kNoRule;
  return target;
}

/// "12-34": the step whose base edge joined these vertices.
Target targetOf(const std::string& edge, int face, const Trace& trace, const Replay& replay) {
  std::size_t from = 0, to = 0;
  const char* const end = edge.data() + edge.size();
  const auto first = std::from_chars(edge.data(), end, from);
  const bool hasDash = first.ec == std::errc() && first.ptr != end && *first.ptr == '-';
  const auto second = hasDash ? std::from_chars(first.ptr + 1, end, to) : first;
  if (!hasDash || second.ec != std::errc() || second.ptr != end)
    throw UsageError(
        fmt::format("--edge '{}': expected the numbers of two vertices, such as 12-34", edge));
  if (const auto found = stepAtEdge(replay, trace, face, from, to))
    return {found->face, found->step};
  throw UsageError(fmt::format(
      "--edge {}: no step had this base edge; --element N finds the step that made an element "
      "beside it",
      edge));
}

FoundStep find(const Replay& replay, const Target& target) {
  std::mutex mutex;
  std::list<std::pair<int, Finder>> finders;  // which stay where they are
  replay.run([&](int face) -> AF2MeshingObserver* {
    if (target.face != 0 && face != target.face) return nullptr;
    const std::lock_guard lock(mutex);
    for (auto& [id, finder] : finders)
      if (id == face) return &finder;
    return &finders
                .emplace_back(std::piecewise_construct, std::tuple(face),
                              std::tuple(std::cref(target), face))
                .second;
  });
  const FoundStep* best = nullptr;
  for (const auto& [face, finder] : finders)
    if (finder.found && (!best || finder.found->distance < best->distance ||
                         (finder.found->distance == best->distance && face < best->face)))
      best = &*finder.found;
  if (!best)
    throw InputError("the run had no such step when it was made again; please report this");
  return *best;
}

std::string headOf(const FoundStep& found, const RuleSet& rules) {
  const StepReport& step = found.report;
  const std::string what = step.applied ? fmt::format("rule \"{}\" (score {:.4g})",
                                                      rules.rules()[step.rule].name(), step.score)
                                        : "no rule";
  return fmt::format("face {}, step {}: {} -> {} from {} to {}, level {}: {}\n", found.face,
                     found.step, step.from.value, step.to.value, textOf(step.fromPoint),
                     textOf(step.toPoint), step.level, what);
}

/// In the run, charts are curved, sizes vary and vertices remember their elements.
bool isSame(const dsl::StepExplanation& explanation, const StepReport& step) {
  return step.applied ? explanation.applied == step.rule : !explanation.applied.has_value();
}

void extract(const ExplainOptions& options, const Replay& replay, const FoundStep& found,
             const dsl::StepExplanation& explanation) {
  dsl::PieceTest test;
  test.title = fmt::format("face {}, step {}", found.face, found.step);
  test.remark = headOf(found, replay.rules()) + toText(explanation);
  test.expectation =
      !options.whyNot.empty() ? fmt::format("rule \"{}\"", options.whyNot)
      : found.report.applied
          ? fmt::format("rule \"{}\"", replay.rules().rules()[found.report.rule].name())
          : std::string("not stuck");
  writeText(options.extract, dsl::testFileHead(replay.ruleFile().string(), replay.rules().name()) +
                                 "\n" + dsl::testTextOf(found.around.piece, test));
}

int explain(const ExplainOptions& options) {
  const Trace trace = readTrace(options.trace);
  const bool isByElement = options.element >= 0;
  const bool isByEdge = !options.edge.empty();
  if (isByElement + isByEdge + (options.step != 0) + !options.at.empty() > 1)
    throw UsageError("--element, --edge, --step and --at name different steps; give one of them");
  Target target;
  if (!isByElement) target = targetOf(options, trace);
  const Replay replay(trace);
  if (isByElement) target = targetOf(options.element, replay);
  if (isByEdge) target = targetOf(options.edge, options.face, trace, replay);
  try {
    if (!options.whyNot.empty()) dsl::findRule(replay.rules(), options.whyNot);
  } catch (const InputError& error) {
    throw UsageError(std::string("--why-not: ") + error.what());
  }
  const FoundStep found = find(replay, target);
  SingleStepper stepper(replay.rules());
  const dsl::StepExplanation explanation = dsl::explainStep(
      replay.rules(), stepper, found.around.piece, dsl::vertexNamesOf(found.around.piece), true);
  if (options.format == "json") {
    fmt::print("{}", toJson(explanation));
  } else {
    fmt::print("{}{}", headOf(found, replay.rules()), toText(explanation, "  ", options.whyNot));
    if (!isSame(explanation, found.report))
      fmt::print(
          "note: the table is for the front in the plane with a uniform size; there the "
          "result differs from that of the run\n");
  }
  if (!options.extract.empty()) extract(options, replay, found, explanation);
  return kComplete;
}

}  // namespace

Action declareExplain(CLI::App& command) {
  const auto options = std::make_shared<ExplainOptions>();
  command.add_option("TRACE", options->trace, "a trace (af2 mesh --trace)")
      ->type_name("")
      ->required();
  command.add_option("--face", options->face, "only this face")->type_name("FACE");
  command.add_option("--step", options->step, "the step with this number in the face, from 1")
      ->type_name("N");
  command.add_option("--at", options->at, "the step whose base edge is nearest to this place")
      ->type_name("X,Y,Z");
  command
      .add_option(
          "--element", options->element,
          "the step that made the element with this number, from 0 as in .vtu files and pages")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber.description(""));
  command
      .add_option("--edge", options->edge,
                  "the last step whose base edge joined these vertices, from 0 as in .vtu files")
      ->type_name("A-B");
  command.add_option("--why-not", options->whyNot, "explain only this rule")->type_name("TITLE");
  command
      .add_option("--extract", options->extract,
                  "file (.af2) for a test with the front around the base edge")
      ->type_name("FILE");
  command.add_option("--format", options->format, "pretty or json")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"pretty", "json"}).description(""));
  return [options] { return explain(*options); };
}

}  // namespace af2::cli
