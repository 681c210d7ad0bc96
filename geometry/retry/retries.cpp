#include "geometry/retry/retries.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "engine/base/parallel.h"
#include "geometry/retry/mesh_again.h"
#include "geometry/retry/protected_neighbors.h"
#include "geometry/retry/remedy.h"
#include "geometry/retry/retry_limits.h"
#include "geometry/retry/score.h"

namespace af2::geometry {

namespace {

/// Goes through the table of remedies: in rounds, of which the best state is kept; then in one
/// last round; then face by face.
class Retries {
 public:
  Retries(const RetriedModel& model, const RetryOptions& options, const FaceMeshes& state)
      : options_(options),
        retrial_{model, options, Refinement(options.sizes, options.growth, options.largest),
                 std::vector<FaceRecord>(model.edgesOfFaces().size()),
                 budgetFor(state.meshes, options.share)} {
    for (std::size_t i = 0; i < state.meshes.size(); ++i)
      if (!state.waits(i)) begin(state, i);
  }

  void retry(FaceMeshes& given) {
    RetryState state{std::move(given), retrial_.requests};
    if (state.meshes.isComplete()) joinWithRemedies(retrial_, state.meshes);
    state = bestOfRounds(std::move(state));
    retrial_.requests = state.requests;
    lastRound(state);
    retrial_.budget = retrial_.budget.anew();
    for (const FaceRemedy& remedy : faceRemedies())
      if (remedy.time == RemedyTime::InPlace) applyInPlace(remedy, state.meshes);
    given = std::move(state.meshes);
    report(given);
  }

 private:
  struct Proposal {
    std::size_t face = 0;
    const FaceRemedy* remedy = nullptr;
  };

  bool isStopped() const { return options_.stop.stop_requested(); }

  void begin(const FaceMeshes& state, std::size_t face) {
    for (const FaceRemedy& remedy : faceRemedies())
      if (remedy.begin) remedy.begin(retrial_, state, face);
  }

  /// Of the complete states, each of which ends a draft. The first one need not be complete: it is
  /// completed only if it might be the best.
  RetryState bestOfRounds(RetryState base) {
    std::optional<RetryState> best, first;
    for (int rounds = 0; !isStopped();) {
      const bool isComplete = base.meshes.isComplete();
      std::optional<Draft> draft = settledDraft(base, rounds);
      if (draft && changesNothing(retrial_, *draft, base.meshes)) draft.reset();
      if (isStopped() || (!draft && isComplete)) break;
      RetryState next = draft ? completedState(base, *std::move(draft), first) : withAll(base);
      if (isStopped() && isComplete) break;
      std::optional<RetryState>& earlier = isComplete ? best : first;
      if (draft && (!earlier || isBetter(base, *earlier))) earlier = std::move(base);
      base = std::move(next);
    }
    if (!base.meshes.isComplete()) base = withAll(base);
    if (best && !isBetter(base, *best)) base = *std::move(best);
    // What waits can only make a state worse.
    if (!first || isBetter(base, *first) || isStopped()) return base;
    RetryState all = withAll(*first);
    return isBetter(base, all) ? base : all;
  }

  static bool isBetter(const RetryState& one, const RetryState& other) {
    return scoreOf(one.meshes) < scoreOf(other.meshes);
  }

  /// Round after round, until the faces that ask for something ask for nothing more. Nothing if no
  /// face of the base does.
  std::optional<Draft> settledDraft(RetryState& base, int& rounds) {
    std::optional<Draft> draft;
    tried_.clear();
    for (; rounds < options_.mostRounds && !isStopped(); ++rounds) {
      FaceMeshes& state = draft ? draft->meshes : base.meshes;
      retrial_.hasBudgetLeft = !retrial_.budget.isOverdrawn();
      const std::vector<Proposal> proposals = propose(RemedyTime::BeforeRound, state);
      const bool hasWithdrawn = !retrial_.withdrawn.empty() && retrial_.hasBudgetLeft;
      if (proposals.empty() && !hasWithdrawn) break;
      std::vector<std::size_t> faces;
      std::ranges::set_union(facesOf(proposals), std::exchange(retrial_.withdrawn, {}),
                             std::back_inserter(faces));
      Draft next = drafted(retrial_, base, draft ? &*draft : nullptr, faces);
      if (isStopped()) break;
      for (const Proposal& proposal : proposals) {
        tried_[proposal.face] = proposal.remedy;
        if (isWorthwhile(state, next.meshes, proposal.face)) continue;
        takeBack(proposal, state, next.meshes);
        tried_.erase(proposal.face);
      }
      sortWithdrawn();
      draft = std::move(next);
    }
    return draft;
  }

  /// Also tells which faces cross others now, and which are worse than they were at first.
  ///
  /// first  the state before any remedy, if it was not complete
  RetryState completedState(RetryState& base, Draft draft, std::optional<RetryState>& first) {
    RetryState next{completed(retrial_, base.meshes, std::move(draft)), retrial_.requests};
    if (!base.meshes.isComplete())
      retrial_.budget.allow(budgetFor(next.meshes.meshes, options_.share));
    joinWithRemedies(retrial_, next.meshes);
    if (isStopped()) return next;
    RetryState& before = first ? *first : base;
    for (std::size_t i = 0; i < next.meshes.meshes.size(); ++i)
      if (before.meshes.waits(i) && isBad(next.meshes.meshes[i])) meshFirst(before.meshes, i);
    for (const auto& [face, remedy] : tried_)
      if (!crossesLess(base.meshes, next.meshes, face))
        takeBack({face, remedy}, base.meshes, next.meshes);
    propose(RemedyTime::AfterRound, next.meshes);
    sortWithdrawn();
    return next;
  }

  /// What a face was without remedies.
  void meshFirst(FaceMeshes& first, std::size_t face) {
    retrial_.model.mesh(face, options_.sizes, {}, first);
    first.isWaiting[face] = false;
    begin(first, face);
  }

  RetryState withAll(RetryState& state) {
    const std::vector<bool> hasWaited = state.meshes.isWaiting;
    meshWaiting(retrial_, state.meshes);
    for (std::size_t i = 0; i < hasWaited.size(); ++i)
      if (hasWaited[i]) begin(state.meshes, i);
    retrial_.budget.allow(budgetFor(state.meshes.meshes, options_.share));
    joinWithRemedies(retrial_, state.meshes);
    return std::move(state);
  }

  void sortWithdrawn() {
    std::ranges::sort(retrial_.withdrawn);
    const auto same = std::ranges::unique(retrial_.withdrawn);
    retrial_.withdrawn.erase(same.begin(), same.end());
  }

  /// For each face the first remedy that applies.
  std::vector<Proposal> propose(RemedyTime time, FaceMeshes& state) {
    std::vector<Proposal> proposals;
    for (std::size_t i = 0; i < state.meshes.size(); ++i) {
      if (state.waits(i)) continue;
      if (time == RemedyTime::BeforeRound && retrial_.faces[i].isGivenUp) continue;
      for (const FaceRemedy& remedy : faceRemedies()) {
        if (remedy.time != time || !remedy.applies(retrial_, state, i)) continue;
        if (const auto places = remedy.propose(retrial_, state, i)) {
          proposals.push_back({i, &remedy});
          if (remedy.isReported)
            retrial_.faces[i].remedies.push_back(triedRemedy(remedy.name, *places));
        }
        break;
      }
    }
    return proposals;
  }

  static std::vector<std::size_t> facesOf(const std::vector<Proposal>& proposals) {
    std::vector<std::size_t> faces;
    for (const Proposal& proposal : proposals) faces.push_back(proposal.face);
    return faces;
  }

  void takeBack(const Proposal& vain, FaceMeshes& state, const FaceMeshes& next) {
    retrial_.faces[vain.face].isGivenUp = true;
    retrial_.withdrawn.push_back(vain.face);
    if (vain.remedy->undo) vain.remedy->undo(retrial_, state, next, vain.face);
  }

  /// Whether a face should be tried once more after `next`, whose elements are not known to cross
  /// any others.
  bool isWorthwhile(const FaceMeshes& state, const FaceMeshes& next, std::size_t i) {
    const FaceMesh &before = state.meshes[i], &after = next.meshes[i];
    FaceRecord& record = retrial_.faces[i];
    if (failed(after)) {
      if (!failed(before)) return false;  // it had a mesh, which must not be lost
      // If no front was tried, the next try is as cheap.
      if (after.searchCost > 0) record.failures += isFurtherOff(before, after) ? kMaxFailures : 1;
      return record.failures < kMaxFailures || !record.shortEdges.empty();
    }
    return failed(before) || crossingsAt(state, i) > 0 ||
           after.diagnosis.poorness < kProgress * before.diagnosis.poorness;
  }

  /// Whether a face that failed again is at fault at more places than before.
  static bool isFurtherOff(const FaceMesh& before, const FaceMesh& after) {
    return after.diagnosis.places.size() > before.diagnosis.places.size();
  }

  /// Or may still come to it.
  bool crossesLess(const FaceMeshes& state, const FaceMeshes& next, std::size_t i) {
    const auto crossed = static_cast<double>(crossingsAt(state, i));
    const auto crosses = static_cast<double>(crossingsAt(next, i));
    if (crosses == 0 || crosses < kProgress * crossed) return true;
    if (++retrial_.faces[i].failures >= kMaxTriesAtCrossings) return false;
    const RetriedModel& model = retrial_.model;  // no edges mend what crosses there
    return !model.hasFaultInModel(i) && !model.meetsOthers(i, next.faults.crossings);
  }

  void lastRound(RetryState& state) {
    const std::vector<std::size_t> faces = facesOf(propose(RemedyTime::LastRound, state.meshes));
    if (faces.empty() || isStopped()) return;
    retrial_.budget = retrial_.budget.anew();
    FaceMeshes next = completed(retrial_, state.meshes, drafted(retrial_, state, nullptr, faces));
    if (isStopped()) return;
    joinWithRemedies(retrial_, next);
    if (scoreOf(next) < scoreOf(state.meshes)) state.meshes = std::move(next);
  }

  /// One face after the other, so that each knows what those before it have left of the budget.
  void applyInPlace(const FaceRemedy& remedy, FaceMeshes& state) {
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < state.meshes.size() && !isStopped(); ++i)
      if (remedy.applies(retrial_, state, i) && remedy.propose(retrial_, state, i))
        changed.push_back(i);
    if (changed.empty()) return;
    joinWithRemedies(retrial_, state);
    for (const std::size_t i : changed) {
      if (crossingsAt(state, i) > 0)
        remedy.undo(retrial_, state, state, i);
      else
        state.meshes[i].history.push_back(triedRemedy(remedy.name, 0));
    }
    joinWithRemedies(retrial_, state);
  }

  void report(FaceMeshes& state) const {
    for (std::size_t i = 0; i < state.meshes.size(); ++i) {
      FaceMesh& mesh = state.meshes[i];
      if (!retrial_.hasBudgetLeft && failed(mesh))
        mesh.history.emplace_back().kind = FaceStepKind::BudgetSpent;
      mesh.report.attempts = textsOf(mesh.history);
      if (i < state.joined.faces.size()) state.joined.faces[i].attempts = mesh.report.attempts;
    }
  }

  const RetryOptions& options_;
  Retrial retrial_;
  std::map<std::size_t, const FaceRemedy*> tried_;  ///< the last one by face, since the last state
};

}  // namespace

void RetriedModel::meshAll(std::span<const FaceTry> tries, const RequestedSizes& sizes, int threads,
                           FaceMeshes& into) const {
  forEachInParallel(tries.size(), threads, [&](std::size_t k) {
    mesh(tries[k].face, sizes.sizes, tries[k].limits, into);
  });
}

void retryPoorFaces(const RetriedModel& model, const RetryOptions& options, FaceMeshes& state) {
  Retries(model, options, state).retry(state);
}

}  // namespace af2::geometry
