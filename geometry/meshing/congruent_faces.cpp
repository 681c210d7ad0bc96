#include "geometry/meshing/congruent_faces.h"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/base/stopwatch.h"
#include "geometry/congruence/moved_mesh.h"

namespace af2::geometry {
namespace {

/// The others of a group are compared with each of these.
constexpr std::size_t kMostMeshed = 4;

}  // namespace

std::vector<TryGroup> CongruentFaces::groupsOf(std::span<const FaceTry> tries,
                                               std::span<const std::size_t> meshed,
                                               const DividedEdges& divided) const {
  std::vector<FaceNumbers> numbers;
  const auto add = [&](std::size_t face) {
    FaceNumbers& of = numbers.emplace_back();
    of.face = numbers.size() - 1;
    if (source_.hasOutlines()) findNumbers(faces_[face], divided, of);
  };
  for (const FaceTry& next : tries) add(next.face);
  for (const std::size_t face : meshed) add(face);
  std::vector<TryGroup> groups;
  for (const std::vector<std::size_t>& similar : similarFaces(std::move(numbers))) {
    if (similar.front() >= tries.size()) continue;
    TryGroup& group = groups.emplace_back();
    for (const std::size_t k : similar) {
      if (k < tries.size())
        group.tries.push_back(tries[k]);
      else if (group.meshed.size() < kMostMeshed)
        group.meshed.push_back(meshed[k - tries.size()]);
    }
  }
  return groups;
}

void CongruentFaces::findNumbers(int face, const DividedEdges& divided, FaceNumbers& of) const {
  FaceReport report = source_.reportOf(face);
  of.surfaceType = std::move(report.surfaceType);
  of.area = report.area;
  for (const int edge : source_.edgesOf(face))
    of.segments.push_back(divided.edges[static_cast<std::size_t>(edge) - 1].points.size());
  std::ranges::sort(of.segments);
}

void CongruentFaces::move(const FaceTry& from, const FaceMesh& mesh, const PositionSize& sizes,
                          const DividedEdges& divided, std::vector<FaceTry>& others,
                          const TakeMovedMesh& take) const {
  if (others.empty()) return;
  FaceMesh loaded;
  if (mesh.bulk) {
    loaded = mesh;
    loadBulk(loaded);
  }
  const FaceMesh& whole = mesh.bulk ? loaded : mesh;
  if (!MovableMesh::isMovable(whole)) return;
  const std::optional<FaceOutline> outline = outlineOf(from, sizes, divided);
  if (!outline) return;
  const MovableMesh movable(*outline, whole);
  std::erase_if(others, [&](const FaceTry& other) {
    if (!other.limits.allow(from.limits, mesh.searchCost)) return false;
    const Stopwatch watch;
    const std::optional<FaceOutline> own = outlineOf(other, sizes, divided);
    FaceMesh moved;
    moved.report = source_.reportOf(faces_[other.face]);
    if (!own || !movable.moveTo(*own, moved)) return false;
    moved.report.seconds = watch.seconds();
    take(other, std::move(moved));
    return true;
  });
}

std::optional<FaceOutline> CongruentFaces::outlineOf(const FaceTry& at, const PositionSize& sizes,
                                                     const DividedEdges& divided) const {
  if (options_.stop.stop_requested()) return std::nullopt;
  const FillOptions fill = fillOptionsOf(options_);
  const ProgressCallback none;
  return source_.outlineOf(
      faces_[at.face], {sizes, at.limits, divided, algorithm_, fill, options_.order == 2, none});
}

void forgetFormerMeshes(std::vector<FaceMesh>& meshes) {
  std::map<int, const FaceMesh*> byId;
  for (const FaceMesh& mesh : meshes) byId[mesh.report.id] = &mesh;
  for (FaceMesh& mesh : meshes) {
    if (mesh.report.congruentTo == 0) continue;
    const FaceMesh& from = *byId.at(mesh.report.congruentTo);
    const bool isSame = from.report.congruentTo == 0 && from.searchCost == mesh.searchCost &&
                        elementCount(from) == elementCount(mesh);
    if (!isSame) mesh.report.congruentTo = 0;
  }
}

}  // namespace af2::geometry
