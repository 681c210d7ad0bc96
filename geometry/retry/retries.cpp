#include "geometry/retry/retries.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "geometry/base/parallel.h"
#include "geometry/retry/mesh_again.h"
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
    for (const FaceRemedy& remedy : faceRemedies())
      if (remedy.begin) remedy.begin(retrial_, state);
  }

  void retry(FaceMeshes& given) {
    State state{std::move(given), retrial_.requests};
    joinWithRemedies(retrial_, state.meshes);
    state = bestOfRounds(std::move(state));
    retrial_.requests = std::move(state.requests);
    lastRound(state.meshes);
    retrial_.budget = retrial_.budget.anew();
    for (const FaceRemedy& remedy : faceRemedies())
      if (remedy.time == RemedyTime::InPlace) applyInPlace(remedy, state.meshes);
    given = std::move(state.meshes);
    report(given);
  }

 private:
  /// Meshes, and what was asked of the edges for them.
  struct State {
    FaceMeshes meshes;
    Refinement requests;
  };

  struct Proposal {
    std::size_t face = 0;
    const FaceRemedy* remedy = nullptr;
  };

  bool isStopped() const { return options_.stop.stop_requested(); }

  State bestOfRounds(State state) {
    std::optional<State> best;
    for (int round = 0; round < options_.mostRounds && !isStopped(); ++round) {
      std::optional<State> next = nextRound(state.meshes);
      if (!next) break;
      if (!best || isBetter(state, *best)) best = std::move(state);
      state = *std::move(next);
    }
    if (best && !isBetter(state, *best)) return *std::move(best);
    return state;
  }

  static bool isBetter(const State& one, const State& other) {
    return scoreOf(one.meshes) < scoreOf(other.meshes);
  }

  /// Nothing if there is nothing more to be tried, or the run was stopped.
  std::optional<State> nextRound(FaceMeshes& state) {
    retrial_.hasBudgetLeft = !retrial_.budget.isOverdrawn();
    const std::vector<Proposal> proposals = propose(RemedyTime::BeforeRound, state);
    const bool hasWithdrawn = !retrial_.withdrawn.empty() && retrial_.hasBudgetLeft;
    if (proposals.empty() && !hasWithdrawn) return std::nullopt;
    std::vector<std::size_t> faces;
    std::ranges::set_union(facesOf(proposals), std::exchange(retrial_.withdrawn, {}),
                           std::back_inserter(faces));
    State next{meshAgain(retrial_, state, faces), retrial_.requests};
    if (isStopped()) return std::nullopt;
    joinWithRemedies(retrial_, next.meshes);
    takeBackVain(proposals, state, next.meshes);
    propose(RemedyTime::AfterRound, next.meshes);
    std::ranges::sort(retrial_.withdrawn);
    const auto same = std::ranges::unique(retrial_.withdrawn);
    retrial_.withdrawn.erase(same.begin(), same.end());
    return next;
  }

  /// For each face the first remedy that applies.
  std::vector<Proposal> propose(RemedyTime time, FaceMeshes& state) {
    std::vector<Proposal> proposals;
    for (std::size_t i = 0; i < state.meshes.size(); ++i) {
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

  void takeBackVain(const std::vector<Proposal>& proposals, FaceMeshes& state,
                    const FaceMeshes& next) {
    for (const auto& [face, remedy] : proposals) {
      if (isWorthwhile(state, next, face)) continue;
      retrial_.faces[face].isGivenUp = true;
      retrial_.withdrawn.push_back(face);
      if (remedy->undo) remedy->undo(retrial_, state, next, face);
    }
  }

  /// Whether a face should be tried once more after `next`.
  bool isWorthwhile(const FaceMeshes& state, const FaceMeshes& next, std::size_t i) {
    const FaceMesh &before = state.meshes[i], &after = next.meshes[i];
    FaceRecord& record = retrial_.faces[i];
    if (failed(after)) {
      // If no front was tried, the next try is as cheap.
      if (after.searchCost > 0) ++record.failures;
      return record.failures < kMaxFailures || !record.shortEdges.empty();
    }
    const auto crossed = static_cast<double>(crossingsAt(state, i));
    const auto crosses = static_cast<double>(crossingsAt(next, i));
    if (crosses > 0)
      return crosses < kProgress * crossed || ++record.failures < kMaxTriesAtCrossings;
    return failed(before) || crossed > 0 ||
           after.diagnosis.poorness < kProgress * before.diagnosis.poorness;
  }

  void lastRound(FaceMeshes& state) {
    const std::vector<std::size_t> faces = facesOf(propose(RemedyTime::LastRound, state));
    if (faces.empty() || isStopped()) return;
    retrial_.budget = retrial_.budget.anew();
    FaceMeshes next = meshAgain(retrial_, state, faces);
    if (isStopped()) return;
    joinWithRemedies(retrial_, next);
    if (scoreOf(next) < scoreOf(state)) state = std::move(next);
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
