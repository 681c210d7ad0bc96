#include "geometry/retry/mesh_again.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "geometry/retry/score.h"

namespace af2::geometry {

namespace {

/// A face that failed and has no width without its short edges has failed still. One that has
/// become a point is none of the mesh any more: its neighbours meet there.
void refuseNothing(const FaceMesh& failure, FaceMesh& mesh) {
  if (failed(mesh) || elementCount(mesh) > 0 || mesh.hasVanished) return;
  const std::string& reason = failure.report.reason;
  mesh.report.status = FaceStatus::Failed;
  mesh.report.reason = reason.empty() ? "the elements did not have the area of the face" : reason;
  mesh.diagnosis = failure.diagnosis;
}

/// The earlier history of a face that is meshed again comes first; steps that recur in each try are
/// not repeated.
void addPast(const FaceMeshes& state, std::size_t i, const FaceHistory& remedies, FaceMesh& after) {
  const FaceMesh& before = state.meshes[i];
  FaceHistory own = std::exchange(after.history, before.history);
  addNew(std::move(own), after.history);
  FaceHistory past;
  if (before.diagnosis.hasWrongArea)
    past.emplace_back().kind = FaceStepKind::WrongArea;
  else if (failed(before))
    past.push_back(failedFace(before.report.reason));
  if (const auto count = crossingsAt(state, i); count > 0)
    past.push_back(crossingElements(static_cast<std::size_t>(count)));
  past.insert(past.end(), remedies.begin(), remedies.end());
  const auto known = static_cast<std::ptrdiff_t>(before.history.size());
  after.history.insert(after.history.begin() + known, past.begin(), past.end());
}

bool touches(const std::vector<int>& edges, const DivisionChange& change) {
  return std::ranges::any_of(
      edges, [&](int edge) { return change.isChanged[static_cast<std::size_t>(edge) - 1]; });
}

/// Takes over what stays as it is. Returns the faces that have to be meshed.
std::vector<std::size_t> takeOver(const Retrial& retrial, const FaceMeshes& state,
                                  const std::vector<std::size_t>& faces, FaceMeshes& next) {
  const DivisionChange change = compare(state.divided, next.divided);
  next.meshes.resize(state.meshes.size());
  std::vector<std::size_t> again;
  for (std::size_t i = 0; i < state.meshes.size(); ++i) {
    if (std::ranges::binary_search(faces, i) || touches(retrial.model.edgesOfFaces()[i], change)) {
      again.push_back(i);
      continue;
    }
    next.meshes[i] = state.meshes[i];
    for (std::uint32_t& point : next.meshes[i].boundary) point = change.newIndex[point];
  }
  return again;
}

}  // namespace

FaceMeshes meshAgain(Retrial& retrial, const FaceMeshes& state,
                     const std::vector<std::size_t>& faces) {
  FaceMeshes next;
  const RequestedSizes sizes = retrial.requests.requested();
  next.divided = retrial.model.divide(sizes.sizes, retrial.requests.collapsedEdges());
  const std::vector<std::size_t> again = takeOver(retrial, state, faces, next);
  const RetryAllowance allowance(state.meshes, again, retrial.budget.left());
  std::vector<FaceTry> tries;
  for (const std::size_t i : again) {
    TryLimits& limits = tries.emplace_back(FaceTry{i, {}}).limits;
    limits.maxCandidates = allowance.maxCandidates(state.meshes[i]);
    limits.failedBefore = failed(state.meshes[i]);
    limits.hasOriginalSizes = false;
  }
  retrial.model.meshAll(tries, sizes, retrial.options.threads, next);
  for (const std::size_t i : again) {
    const FaceMesh& before = state.meshes[i];
    if (failed(before)) refuseNothing(before, next.meshes[i]);
    addPast(state, i, retrial.faces[i].remedies, next.meshes[i]);
    retrial.budget.charge(next.meshes[i]);
    retrial.faces[i].remedies.clear();
  }
  return next;
}

void joinWithRemedies(const Retrial& retrial, FaceMeshes& state) {
  retrial.model.join(state);
  for (const MeshRemedy& remedy : meshRemedies()) {
    if (!remedy.applies(state.faults)) continue;
    FaceMeshes other{state.divided, state.meshes, {}, {}};
    if (remedy.propose(other.divided, other.meshes) == 0) continue;
    retrial.model.join(other);
    if (remedy.isBetter(state.faults, other.faults)) state = std::move(other);
  }
}

}  // namespace af2::geometry
