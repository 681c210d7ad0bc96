#include "cli/trace_view/edge_step.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "cli/program/usage_error.h"
#include "cli/trace_view/face_recorder.h"
#include "cli/trace_view/kept_fronts.h"

namespace af2::cli {
namespace {

/// Where the vertices of a record are after all moves.
std::vector<Point3> placesAtEnd(const FaceRecord& record) {
  constexpr auto kMove = ViewEvent::kFirstAct + static_cast<std::size_t>(FinishAct::Kind::Move);
  std::vector<Point3> places = record.vertices;
  std::size_t move = 0;
  for (const ViewEvent& event : record.events)
    if (event.kind == kMove) places[event.from] = record.moves[move++];
  return places;
}

std::size_t lastStepAt(const FaceRecord& record, const Point3& one, const Point3& other) {
  const std::vector<Point3> places = placesAtEnd(record);
  std::size_t step = 0, found = 0;
  for (const ViewEvent& event : record.events) {
    if (event.kind > ViewEvent::kApplied) continue;
    ++step;
    if (record.fronts[static_cast<std::size_t>(event.front)].kept == ViewFront::Kept::No) continue;
    const Point3 &from = places[event.from], &to = places[event.to];
    if ((from == one && to == other) || (from == other && to == one)) found = step;
  }
  return found;
}

}  // namespace

std::optional<StepOfFace> stepAtEdge(const Replay& replay, const Trace& trace, int face,
                                     std::size_t from, std::size_t to) {
  constexpr StepRange kNoCharts;
  std::map<int, FaceRecorder> recorders;
  for (const auto& [id, entries] : trace.faces)
    if (face == 0 || id == face) recorders.try_emplace(id, replay.rules(), id, kNoCharts);
  const geometry::ModelMesh mesh = replay.run([&](int id) -> AF2MeshingObserver* {
    const auto recorder = recorders.find(id);
    return recorder == recorders.end() ? nullptr : &recorder->second;
  });
  const std::size_t count = geometry::cornerVertices(mesh).size();
  if (std::max(from, to) >= count)
    throw UsageError(fmt::format("--edge {}-{}: the mesh has vertices 0 to {}", from, to,
                                 static_cast<std::ptrdiff_t>(count) - 1));
  std::vector<FaceRecord*> faces;
  for (auto& [id, recorder] : recorders) faces.push_back(&recorder.record());
  markKeptFronts(mesh, faces);
  for (const FaceRecord* record : faces)
    if (const std::size_t step = lastStepAt(*record, mesh.vertices[from], mesh.vertices[to]))
      return StepOfFace{record->face, step};
  return std::nullopt;
}

}  // namespace af2::cli
