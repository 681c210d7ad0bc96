#include "geometry/retry/retries.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>

#include "geometry/base/parallel.h"
#include "geometry/retry/common_sides.h"
#include "geometry/retry/refinement.h"
#include "geometry/retry/retry_allowance.h"
#include "geometry/retry/spared_neighbors.h"

namespace af2::geometry {

namespace {

class Retries {
 public:
  Retries(const RetriedModel& model, const RetryOptions& options)
      : model_(model), options_(options), tries_(model.edgesOfFaces().size()) {}

  void retry(FaceMeshes& state) {
    Refinement refinement(options_.sizes, options_.growth, options_.largest);
    Refinement ofState = refinement, ofBest = refinement;  // with which these were made
    FaceMeshes best;
    std::vector<std::size_t> dropped;  // faces for which nothing was of use
    SparedNeighbors neighbors(model_.edgesOfFaces(), state.meshes);
    findShortEdges(state);
    most_ = mostEffort(state.meshes, options_.share);
    double effort = 0;
    join(state);
    for (int round = 0; round < options_.mostRounds && !options_.stop.stop_requested(); ++round) {
      hasEffortLeft_ = effort <= most_;
      const std::vector<std::size_t> poor = worthAnotherTry(state);
      if (poor.empty() && (dropped.empty() || !hasEffortLeft_)) break;
      for (const std::size_t i : poor) askForMore(state, i, refinement);
      std::vector<std::size_t> again;
      std::ranges::set_union(poor, dropped, std::back_inserter(again));
      const Refinement ofNext = refinement;
      FaceMeshes next = refined(state, again, ofNext, effort);
      if (options_.stop.stop_requested()) break;
      join(next);
      dropped.clear();
      for (const std::size_t i : poor) {
        if (isWorthwhile(state, next, i)) continue;
        tries_[i].isHopeless = true;
        dropped.push_back(i);
        takeBack(state, next, i, refinement);
      }
      neighbors.spare(next.meshes, refinement, dropped,
                      [&](std::size_t i) { tries_[i].isHopeless = true; });
      if (best.meshes.empty() || isBetter(state, best)) {
        best = std::move(state);
        ofBest = ofState;
      }
      state = std::move(next);
      ofState = ofNext;
    }
    if (!best.meshes.empty() && !isBetter(state, best)) {
      state = std::move(best);
      ofState = ofBest;
    }
    takeBackFailed(state, ofState);
    lean(state);
    if (!hasEffortLeft_) tellOfGivenUp(state);
  }

 private:
  /// What was tried on a face, and what may be tried yet.
  struct Tries {
    bool wasTried = false, isHopeless = false;
    int failures = 0;
    std::vector<EdgesAsPoints> shortEdges;  ///< to be given up, one after the other, the last first
  };

  /// Edges inside several faces that have the same ends are swapped, if the mesh is better so.
  void join(FaceMeshes& state) const {
    model_.join(state);
    if (state.faults.findings.empty()) return;
    FaceMeshes parted{state.divided, state.meshes, {}, {}};
    if (partCommonSides(parted.divided, parted.meshes) == 0) return;
    model_.join(parted);
    const MeshFaults &before = state.faults, &after = parted.faults;
    if (after.findings.size() < before.findings.size() &&
        after.crossings.size() <= before.crossings.size())
      state = std::move(parted);
  }

  void findShortEdges(const FaceMeshes& state) {
    for (std::size_t i = 0; i < state.meshes.size(); ++i) {
      const FaceDiagnosis& diagnosis = state.meshes[i].diagnosis;
      if (!failed(state.meshes[i]) || !diagnosis.isBad) continue;  // without a boundary all is lost
      tries_[i].shortEdges = model_.shortEdges(i, state.divided, diagnosis.places);
      std::ranges::reverse(tries_[i].shortEdges);
    }
  }

  /// Shorter edges where a face is at fault. If these are of no use to one that failed, it does
  /// without the short edges of the model there.
  void askForMore(const FaceMeshes& state, std::size_t i, Refinement& refinement) {
    Tries& tries = tries_[i];
    if (mayDropShortEdges(state, i)) {
      refinement.dropAll(i);
      refinement.takeForPoints(i, tries.shortEdges.back());
      tries.shortEdges.pop_back();
      return;
    }
    refinement.add(i, wantedPlaces(state, i));
    tries.wasTried = true;
  }

  /// A face that failed may be bent more than its size can follow, wherever that was, or nowhere.
  std::vector<SizeSource> wantedPlaces(const FaceMeshes& state, std::size_t i) const {
    std::vector<SizeSource> places = placesOf(state, i);
    if (failed(state.meshes[i]) && !tries_[i].wasTried)
      std::ranges::move(model_.sizesInside(i), std::back_inserter(places));
    return places;
  }

  /// Only where shorter edges did not help, or nobody knows where they should be. To mesh a face
  /// with fewer edges costs little.
  bool mayDropShortEdges(const FaceMeshes& state, std::size_t i) const {
    constexpr int kFailures = 2;
    const Tries& tries = tries_[i];
    return failed(state.meshes[i]) && !tries.shortEdges.empty() &&
           (tries.failures >= kFailures || !hasEffortLeft_ ||
            state.meshes[i].diagnosis.places.empty());
  }

  /// What was of no use to a face.
  static void takeBack(const FaceMeshes& state, const FaceMeshes& next, std::size_t i,
                       Refinement& refinement) {
    if (failed(state.meshes[i]))
      refinement.dropAll(i);
    else if (failed(next.meshes[i]) || crossingsAt(next, i) > 0)
      refinement.dropPlaces(i);
    else
      refinement.dropLast(i);
  }

  /// So that the last way begins as if nothing had been tried.
  void takeBackFailed(FaceMeshes& state, Refinement refinement) const {
    std::vector<std::size_t> faces;
    for (std::size_t i = 0; i < state.meshes.size(); ++i)
      if (failed(state.meshes[i]) && refinement.dropAll(i)) faces.push_back(i);
    if (faces.empty() || options_.stop.stop_requested()) return;
    double effort = 0;
    FaceMeshes next = refined(state, faces, refinement, effort);
    if (options_.stop.stop_requested()) return;
    join(next);
    if (isBetter(next, state)) state = std::move(next);
  }

  /// The last way for faces that failed; without those that then cross others. One after the other,
  /// so that each knows what those before it have left.
  void lean(FaceMeshes& state) {
    constexpr double kAlways = 300'000;
    std::vector<std::pair<std::size_t, FaceMesh>> before;
    auto faces = static_cast<double>(std::ranges::count_if(state.meshes, failed));
    double left = most_;
    for (std::size_t i = 0; i < state.meshes.size() && !options_.stop.stop_requested(); ++i) {
      if (!failed(state.meshes[i])) continue;
      if (left <= 0) {
        hasEffortLeft_ = false;
        break;
      }
      const double most = std::min(left, std::max(kAlways, left / faces--));
      FaceMesh was = std::move(state.meshes[i]);
      model_.mesh(i, options_.sizes, {static_cast<std::size_t>(most), true}, state);
      const FaceMesh& leaning = state.meshes[i];
      left -= static_cast<double>(leaning.effort) + kForEachFace;
      if (failed(leaning) || leaning.elements.empty() || reachesTooFar(leaning, state.divided))
        state.meshes[i] = std::move(was);
      else
        before.emplace_back(i, std::move(was));
    }
    if (before.empty()) return;
    join(state);
    for (auto& [i, was] : before) {
      if (crossingsAt(state, i) > 0) {
        state.meshes[i] = std::move(was);
      } else {
        std::vector<std::string>& steps = was.report.attempts;
        steps.push_back(was.report.reason);
        steps.push_back("elements that lean against the surface");
        state.meshes[i].report.attempts = std::move(steps);
      }
    }
    join(state);
  }

  static void tellOfGivenUp(FaceMeshes& state) {
    for (FaceMesh& mesh : state.meshes)
      if (failed(mesh))
        mesh.report.attempts.emplace_back(
            "not everything was tried: faces that fail have taken too long already");
  }

  std::vector<std::size_t> worthAnotherTry(const FaceMeshes& state) const {
    std::vector<std::size_t> poor;
    for (std::size_t i = 0; i < state.meshes.size(); ++i) {
      const FaceDiagnosis& diagnosis = state.meshes[i].diagnosis;
      if (tries_[i].isHopeless) continue;
      const bool mayAsk = diagnosis.isBad || !tries_[i].wasTried;
      if (mayDropShortEdges(state, i) ||
          (hasEffortLeft_ &&
           (crossingsAt(state, i) > 0 || (mayAsk && !wantedPlaces(state, i).empty()))))
        poor.push_back(i);
    }
    return poor;
  }

  static std::ptrdiff_t crossingsAt(const FaceMeshes& state, std::size_t i) {
    const int face = state.meshes[i].report.id;
    return std::ranges::count_if(state.faults.crossings, [&](const Crossing& crossing) {
      return std::ranges::count(crossing.faces, face) > 0;
    });
  }

  /// Those of the diagnosis; and where elements cross, half as long as these. Where two faces all
  /// but touch along a curve, new crossings arise beside those that went: once that did not help
  /// some times, a quarter, so that what is finer reaches farther.
  std::vector<SizeSource> placesOf(const FaceMeshes& state, std::size_t i) const {
    constexpr double kFiner = 0.5, kMuchFiner = 0.25;
    constexpr int kPatience = 3;
    constexpr std::size_t kMostCrossed = 1000;
    const double share = tries_[i].failures < kPatience ? kFiner : kMuchFiner;
    const int face = state.meshes[i].report.id;
    std::vector<SizeSource> places = state.meshes[i].diagnosis.places;
    const std::size_t most = places.size() + kMostCrossed;
    for (const Crossing& crossing : state.faults.crossings)
      for (std::size_t k = 0; k < 2 && places.size() < most; ++k) {
        if (crossing.faces[k] != face) continue;
        const auto corners = state.joined.elements[crossing.elements[k].value].vertices();
        double longest = 0;
        for (const VertexId a : corners)
          for (const VertexId b : corners)
            longest = std::max(
                longest, distance(state.joined.vertices[a.value], state.joined.vertices[b.value]));
        places.push_back({crossing.place, share * longest});
      }
    return places;
  }

  /// Whether a face should be tried once more after `next`.
  bool isWorthwhile(const FaceMeshes& state, const FaceMeshes& next, std::size_t i) {
    constexpr double kGain = 0.9;
    constexpr int kMostCrossed = 10;
    const FaceMesh &before = state.meshes[i], &after = next.meshes[i];
    int& failures = tries_[i].failures;
    if (failed(after)) {
      if (after.effort > 0) ++failures;  // else no front was tried, and the next try is as cheap
      return failures < kMostFailures || !tries_[i].shortEdges.empty();
    }
    const auto crossed = static_cast<double>(crossingsAt(state, i));
    const auto crosses = static_cast<double>(crossingsAt(next, i));
    if (crosses > 0) return crosses < kGain * crossed || ++failures < kMostCrossed;
    return failed(before) || crossed > 0 ||
           after.diagnosis.poorness < kGain * before.diagnosis.poorness;
  }

  static bool isBetter(const FaceMeshes& one, const FaceMeshes& other) {
    const auto rank = [](const FaceMeshes& state) {
      // The fewest elements, if all else is equal.
      std::tuple<std::size_t, std::size_t, double, std::size_t> sum{0, 0, 0, 0};
      for (const FaceMesh& mesh : state.meshes) {
        if (failed(mesh))
          ++std::get<0>(sum);
        else
          std::get<2>(sum) += mesh.diagnosis.poorness;
        if (mesh.diagnosis.hasBadAngle) ++std::get<1>(sum);
        std::get<3>(sum) += mesh.elements.size();
      }
      std::get<0>(sum) += facesThatCross(state.faults.crossings, {}).size();
      return sum;
    };
    return rank(one) < rank(other);
  }

  /// The edges divided anew, the faces meshed anew that are at fault or lie at edges that changed.
  FaceMeshes refined(const FaceMeshes& state, const std::vector<std::size_t>& poor,
                     const Refinement& refinement, double& effort) const {
    const PositionSize sizes = refinement.sizes();
    FaceMeshes next;
    next.divided = model_.divide(sizes, refinement.edgesAsPoints());
    const DivisionChange change = compare(state.divided, next.divided);
    next.meshes.resize(state.meshes.size());
    std::vector<std::size_t> again;
    for (std::size_t i = 0; i < state.meshes.size(); ++i) {
      if (std::ranges::binary_search(poor, i) || touches(i, change)) {
        again.push_back(i);
        continue;
      }
      next.meshes[i] = state.meshes[i];
      for (std::uint32_t& point : next.meshes[i].boundary) point = change.newIndex[point];
    }
    const RetryAllowance allowance(state.meshes, again, most_ - effort);
    forEachInParallel(again.size(), options_.threads, [&](std::size_t k) {
      const FaceMesh& before = state.meshes[again[k]];
      FaceMesh& after = next.meshes[again[k]];
      model_.mesh(again[k], sizes, {allowance.mostCandidates(before)}, next);
      if (failed(before)) refuseNothing(before, after);
      tellOfRetry(state, again[k], after);
    });
    for (const std::size_t i : again)
      effort += static_cast<double>(next.meshes[i].effort) + kForEachFace;
    return next;
  }

  /// A face that failed and is nothing without its short edges has failed still.
  static void refuseNothing(const FaceMesh& failure, FaceMesh& mesh) {
    if (failed(mesh) || !mesh.elements.empty()) return;
    mesh.report.status = FaceStatus::Failed;
    mesh.report.reason = failure.report.reason;
    mesh.diagnosis = failure.diagnosis;
  }

  /// What a face that is meshed again has behind it.
  void tellOfRetry(const FaceMeshes& state, std::size_t i, FaceMesh& after) const {
    const FaceMesh& before = state.meshes[i];
    std::vector<std::string> steps = before.report.attempts;
    if (before.diagnosis.hasWrongArea)
      steps.push_back("the elements have another area than the face");
    else if (failed(before))
      steps.push_back(before.report.reason);
    if (const auto count = crossingsAt(state, i); count > 0)
      steps.push_back(std::to_string(count) + " pairs of elements cross here");
    const std::size_t places = placesOf(state, i).size();
    if (places > 0) steps.push_back("shorter edges at " + std::to_string(places) + " places");
    std::vector<std::string>& own = after.report.attempts;
    std::erase_if(own, [&](const std::string& step) {  // what is so of the face at each try
      return std::ranges::find(before.report.attempts, step) != before.report.attempts.end();
    });
    own.insert(own.begin(), steps.begin(), steps.end());
  }

  bool touches(std::size_t i, const DivisionChange& change) const {
    return std::ranges::any_of(model_.edgesOfFaces()[i], [&](int edge) {
      return change.isChanged[static_cast<std::size_t>(edge) - 1];
    });
  }

  /// So often shorter edges are tried on a face that fails.
  static constexpr int kMostFailures = 3;

  const RetriedModel& model_;
  const RetryOptions& options_;
  std::vector<Tries> tries_;  // by face
  double most_ = 0;           // candidates that tries may cost
  bool hasEffortLeft_ = true;
};

}  // namespace

void retryPoorFaces(const RetriedModel& model, const RetryOptions& options, FaceMeshes& state) {
  Retries(model, options).retry(state);
}

}  // namespace af2::geometry
