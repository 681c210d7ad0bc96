#include "cli/trace_view/trace_view.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <vector>

#include "cli/meshing/replay.h"
#include "cli/program/exit_code.h"
#include "cli/program/usage_error.h"
#include "cli/trace_view/face_recorder.h"
#include "cli/trace_view/kept_fronts.h"
#include "cli/trace_view/view_page.h"
#include "geometry/base/file_extension.h"
#include "geometry/io/output_file.h"

namespace af2::cli {
namespace {

std::size_t stepsOf(const FaceTrace& entries) {
  return static_cast<std::size_t>(std::ranges::count_if(entries, &TraceEntry::isStep));
}

void checkSteps(const TraceViewOptions& options, const Trace& trace) {
  if (options.from == 0 && options.to == 0) return;
  const bool isOneFace = options.face != 0 || trace.faces.size() == 1;
  if (!isOneFace)
    throw UsageError("--from and --to need --face, because the trace has several faces");
  const int face = options.face != 0 ? options.face : trace.faces.begin()->first;
  const auto steps = static_cast<int>(stepsOf(trace.faces.at(face)));
  for (const auto& [name, step] : {std::pair("--from", options.from), {"--to", options.to}})
    if (step < 0 || step > steps)
      throw UsageError(fmt::format("{} {}: face {} has steps 1 to {}", name, step, face, steps));
  if (options.to != 0 && options.from > options.to)
    throw UsageError(fmt::format("--from {} --to {}: the first step comes after the last one",
                                 options.from, options.to));
}

void check(const TraceViewOptions& options, const Trace& trace) {
  if (geometry::extensionOf(options.output) != ".html")
    throw UsageError(
        fmt::format("--output '{}': the page needs a name that ends in .html", options.output));
  if (options.face != 0 && !trace.faces.contains(options.face))
    throw UsageError(fmt::format("--face {}: the trace has no steps of this face", options.face));
  checkSteps(options, trace);
  geometry::checkWritable(options.output);
}

/// By face of the page: the steps that get a chart. The first steps of the first faces do, so that
/// the result does not depend on which face is meshed first.
std::map<int, StepRange> chartedSteps(const TraceViewOptions& options, const Trace& trace) {
  std::map<int, StepRange> ranges;
  auto left = static_cast<std::size_t>(options.charts);
  for (const auto& [face, entries] : trace.faces) {
    if (options.face != 0 && face != options.face) continue;
    const std::size_t first = std::max(options.from, 1);
    const std::size_t end =
        options.to > 0 ? static_cast<std::size_t>(options.to) + 1 : stepsOf(entries) + 1;
    const std::size_t count = std::min(left, end - std::min(first, end));
    ranges[face] = {first, first + count - 1};
    left -= count;
  }
  return ranges;
}

std::vector<std::string> notesOf(const TraceViewOptions& options,
                                 const std::vector<FaceRecord*>& faces) {
  std::size_t steps = 0, charts = 0;
  bool missesChanges = false;
  for (const FaceRecord* face : faces) {
    steps += static_cast<std::size_t>(std::ranges::count_if(face->events, [](const ViewEvent& e) {
      return e.kind == ViewEvent::kRefused || e.kind == ViewEvent::kApplied;
    }));
    charts += face->charts.size();
    missesChanges = missesChanges || face->missesChanges;
  }
  std::vector<std::string> notes;
  if (charts >= static_cast<std::size_t>(options.charts) && charts < steps)
    notes.push_back(fmt::format(
        "The page has charts of {} of the {} steps. --face, --from and --to choose others, and "
        "--charts N keeps more.",
        charts, steps));
  if (missesChanges)
    notes.push_back(
        "Some changes after the fronts are not shown: those along cuts of large faces, and those "
        "of faces that were laid out in a plane.");
  return notes;
}

bool isAllKept(const FaceRecord* face) {
  return std::ranges::all_of(
      face->fronts, [](const ViewFront& front) { return front.kept == ViewFront::Kept::Yes; });
}

/// "face 3: 2 fronts; kept: 2"
void printKept(const FaceRecord& face) {
  using Kept = ViewFront::Kept;
  std::string kept, unknown;
  for (std::size_t f = 0; f < face.fronts.size(); ++f) {
    if (face.fronts[f].kept == Kept::No) continue;
    std::string& list = face.fronts[f].kept == Kept::Yes ? kept : unknown;
    list += (list.empty() ? "" : ", ") + std::to_string(f + 1);
  }
  fmt::print("face {}: {} front{}; kept: {}{}\n", face.face, face.fronts.size(),
             face.fronts.size() == 1 ? "" : "s", kept.empty() ? "none" : kept,
             unknown.empty() ? "" : "; unknown: " + unknown);
}

void printKept(std::vector<FaceRecord*> faces) {
  constexpr std::size_t kMostLines = 10;
  std::erase_if(faces, isAllKept);
  for (std::size_t f = 0; f < std::min(kMostLines, faces.size()); ++f) printKept(*faces[f]);
  if (faces.size() > kMostLines)
    fmt::print("{} more faces had several fronts; the page says which were kept\n",
               faces.size() - kMostLines);
}

}  // namespace

int viewTrace(const TraceViewOptions& options) {
  const Trace trace = readTrace(options.trace);
  check(options, trace);
  const Replay replay(trace);
  const std::map<int, StepRange> charted = chartedSteps(options, trace);
  std::map<int, FaceRecorder> recorders;
  for (const auto& [face, range] : charted)
    recorders.try_emplace(face, replay.rules(), face, range);
  const geometry::ModelMesh mesh = replay.run([&](int face) -> AF2MeshingObserver* {
    const auto found = recorders.find(face);
    return found == recorders.end() ? nullptr : &found->second;
  });
  std::vector<FaceRecord*> faces;
  for (auto& [face, recorder] : recorders) faces.push_back(&recorder.record());
  markKeptFronts(mesh, faces);
  for (auto& [face, recorder] : recorders) recorder.addClosing(mesh);
  ViewSubject subject{replay.rules(), replay.ruleTexts(), mesh, notesOf(options, faces)};
  subject.firstStep = static_cast<std::size_t>(std::max(options.from, 1));
  subject.lastStep = static_cast<std::size_t>(options.to);
  writeViewPage(subject, faces, options.output);
  printKept(faces);
  for (const std::string& note : subject.notes) fmt::print("note: {}\n", note);
  fmt::print("wrote {}\n", options.output);
  return kComplete;
}

}  // namespace af2::cli
