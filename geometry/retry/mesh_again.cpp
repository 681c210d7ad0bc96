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
///
/// crossings  of elements of the face with others, before
void addPast(const FaceMesh& before, std::ptrdiff_t crossings, const FaceHistory& remedies,
             FaceMesh& after) {
  FaceHistory own = std::exchange(after.history, before.history);
  addNew(std::move(own), after.history);
  FaceHistory past;
  if (before.diagnosis.hasWrongArea)
    past.emplace_back().kind = FaceStepKind::WrongArea;
  else if (failed(before))
    past.push_back(failedFace(before.report.reason));
  if (crossings > 0) past.push_back(crossingElements(static_cast<std::size_t>(crossings)));
  past.insert(past.end(), remedies.begin(), remedies.end());
  const auto known = static_cast<std::ptrdiff_t>(before.history.size());
  after.history.insert(after.history.begin() + known, past.begin(), past.end());
}

bool touches(const std::vector<int>& edges, const DivisionChange& change) {
  return std::ranges::any_of(
      edges, [&](int edge) { return change.isChanged[static_cast<std::size_t>(edge) - 1]; });
}

FaceMesh withIndices(FaceMesh mesh, const DivisionChange& change) {
  for (std::uint32_t& point : mesh.boundary) point = change.newIndex[point];
  return mesh;
}

/// Meshes some faces.
class Meshing {
 public:
  /// state  null: the base is the last state
  Meshing(Retrial& retrial, const FaceMeshes& base, const FaceMeshes* state)
      : retrial_(retrial), base_(base), state_(state) {}

  void mesh(const std::vector<std::size_t>& faces, const RequestedSizes& sizes,
            FaceMeshes& into) const {
    std::vector<const FaceMesh*> before;
    for (const std::size_t i : faces) before.push_back(&lastOf(i));
    retrial_.model.meshAll(triesAt(faces, before), sizes, retrial_.options.threads, into);
    for (std::size_t k = 0; k < faces.size(); ++k) finish(faces[k], *before[k], into);
  }

 private:
  bool isInState(std::size_t i) const { return state_ && !state_->waits(i); }
  /// A face that waits for its first mesh has an empty one.
  const FaceMesh& lastOf(std::size_t i) const {
    return isInState(i) ? state_->meshes[i] : base_.meshes[i];
  }
  bool isFirst(std::size_t i) const { return !isInState(i) && base_.waits(i); }

  std::vector<FaceTry> triesAt(const std::vector<std::size_t>& faces,
                               const std::vector<const FaceMesh*>& before) const {
    const RetryAllowance allowance(before, retrial_.budget.left());
    std::vector<FaceTry> tries;
    for (std::size_t k = 0; k < faces.size(); ++k) {
      TryLimits& limits = tries.emplace_back(FaceTry{faces[k], {}}).limits;
      limits.maxCandidates = allowance.maxCandidates(*before[k]);
      limits.failedBefore = failed(*before[k]);
      limits.hasOriginalSizes = false;
    }
    return tries;
  }

  void finish(std::size_t i, const FaceMesh& before, FaceMeshes& into) const {
    FaceMesh& mesh = into.meshes[i];
    FaceHistory& remedies = retrial_.faces[i].remedies;
    if (failed(before)) refuseNothing(before, mesh);
    addPast(before, isInState(i) ? 0 : crossingsAt(base_, i), remedies, mesh);
    if (!isFirst(i)) retrial_.budget.charge(mesh);
    remedies.clear();
  }

  Retrial& retrial_;
  const FaceMeshes& base_;
  const FaceMeshes* state_;
};

/// Tells in the history of a face that keeps its mesh what was tried without effect.
void tellRemedies(Retrial& retrial, std::size_t i, FaceMesh& mesh) {
  FaceHistory& remedies = retrial.faces[i].remedies;
  mesh.history.insert(mesh.history.end(), remedies.begin(), remedies.end());
  remedies.clear();
}

/// What the history of a draft tells belongs to the face also if it gets its former mesh back.
void keepVain(const FaceMesh& former, const FaceMesh& draft, FaceHistory& remedies) {
  FaceHistory all = former.history;
  addNew(FaceHistory(draft.history), all);
  remedies.insert(remedies.begin(),
                  all.begin() + static_cast<std::ptrdiff_t>(former.history.size()), all.end());
}

/// Takes over what stays as it is.
///
/// again  becomes the faces that have to be meshed
void keepFromDraft(const Retrial& retrial, const FaceMeshes& draft,
                   const std::vector<bool>& isAsked, FaceMeshes& next,
                   std::vector<std::size_t>& again) {
  const DivisionChange change = compare(draft.divided, next.divided);
  for (std::size_t i = 0; i < isAsked.size(); ++i) {
    if (isAsked[i] || draft.waits(i)) continue;
    if (touches(retrial.model.edgesOfFaces()[i], change))
      again.push_back(i);
    else
      next.meshes[i] = withIndices(draft.meshes[i], change);
    next.isWaiting[i] = false;
  }
}

}  // namespace

Draft drafted(Retrial& retrial, const RetryState& base, const Draft* draft,
              const std::vector<std::size_t>& faces) {
  const std::size_t count = base.meshes.meshes.size();
  Draft made{{}, retrial.requests.requested()};
  FaceMeshes& next = made.meshes;
  next.divided = retrial.model.divide(made.sizes.sizes, retrial.requests.collapsedEdges());
  next.meshes.resize(count);
  next.isWaiting.assign(count, true);
  std::vector<bool> isAsked(count, false);
  const DivisionChange change = compare(base.meshes.divided, next.divided);
  std::vector<std::size_t> again;
  for (const std::size_t i : faces) {
    isAsked[i] = true;
    const bool isAsBefore = !base.meshes.waits(i) && retrial.requests.asksAlike(base.requests, i) &&
                            !touches(retrial.model.edgesOfFaces()[i], change);
    if (!isAsBefore)
      again.push_back(i);
    else if (draft && !draft->meshes.waits(i))
      keepVain(base.meshes.meshes[i], draft->meshes.meshes[i], retrial.faces[i].remedies);
  }
  if (draft) keepFromDraft(retrial, draft->meshes, isAsked, next, again);
  std::ranges::sort(again);
  for (const std::size_t i : again) next.isWaiting[i] = false;
  Meshing(retrial, base.meshes, draft ? &draft->meshes : nullptr).mesh(again, made.sizes, next);
  return made;
}

bool changesNothing(Retrial& retrial, const Draft& draft, FaceMeshes& base) {
  if (std::ranges::count(draft.meshes.isWaiting, false) > 0) return false;
  if (std::ranges::count(compare(base.divided, draft.meshes.divided).isChanged, true) > 0)
    return false;
  for (std::size_t i = 0; i < base.meshes.size(); ++i) tellRemedies(retrial, i, base.meshes[i]);
  return true;
}

FaceMeshes completed(Retrial& retrial, const FaceMeshes& base, Draft draft) {
  FaceMeshes next = std::move(draft.meshes);
  const DivisionChange change = compare(base.divided, next.divided);
  std::vector<std::size_t> again;
  for (std::size_t i = 0; i < next.meshes.size(); ++i) {
    if (!next.waits(i)) continue;
    if (base.waits(i) || touches(retrial.model.edgesOfFaces()[i], change)) {
      again.push_back(i);
      continue;
    }
    next.meshes[i] = withIndices(base.meshes[i], change);
    tellRemedies(retrial, i, next.meshes[i]);
  }
  Meshing(retrial, base, nullptr).mesh(again, draft.sizes, next);
  next.isWaiting.clear();
  return next;
}

void meshWaiting(const Retrial& retrial, FaceMeshes& state) {
  std::vector<FaceTry> tries;
  for (std::size_t i = 0; i < state.meshes.size(); ++i)
    if (state.waits(i)) tries.push_back({i, {}});
  retrial.model.meshAll(tries, {{}, retrial.options.sizes}, retrial.options.threads, state);
  state.isWaiting.clear();
}

void joinWithRemedies(const Retrial& retrial, FaceMeshes& state) {
  retrial.model.join(state);
  for (const MeshRemedy& remedy : meshRemedies()) {
    if (!remedy.applies(state.faults)) continue;
    FaceMeshes other{state.divided, state.meshes, {}, {}, {}};
    if (remedy.propose(other.divided, other.meshes) == 0) continue;
    retrial.model.join(other);
    if (remedy.isBetter(state.faults, other.faults)) state = std::move(other);
  }
}

}  // namespace af2::geometry
