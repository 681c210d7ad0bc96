#include "geometry/occ/retries.h"

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <iterator>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "geometry/occ/parallel.h"
#include "geometry/occ/refinement.h"
#include "geometry/occ/sizing.h"

namespace af2::geometry {

namespace {

bool failed(const FaceMesh& mesh) { return mesh.report.status == FaceStatus::Failed; }

/// Sees to it that shorter edges for the sake of one face do not spoil those beside it: where
/// curves touch at an angle of zero, the element there is the worse the shorter it is.
class Neighbors {
 public:
  Neighbors(const RetryTask& task, const std::vector<FaceMesh>& before)
      : task_(task), softened_(before.size(), 0) {
    for (const FaceMesh& mesh : before) wasBad_.push_back(failed(mesh) || mesh.trouble.hasBadAngle);
  }

  /// Takes back what spoiled a face that was good, or softens it if the face that it was meant for
  /// cannot do without. Adds to `changed` the faces concerned.
  void spare(const FaceMeshes& next, Refinement& refinement, std::vector<bool>& isHopeless,
             std::vector<std::size_t>& changed) {
    for (std::size_t i = 0; i < next.meshes.size(); ++i) {
      if (wasBad_[i] || !(failed(next.meshes[i]) || next.meshes[i].trouble.hasBadAngle)) continue;
      for (const std::size_t culprit : beside(i)) {
        if (!refinement.has(culprit) || !yields(culprit, refinement)) continue;
        isHopeless[culprit] = true;  // it asks for no more
        changed.push_back(culprit);
      }
    }
    std::ranges::sort(changed);
    changed.erase(std::ranges::unique(changed).begin(), changed.end());
  }

 private:
  bool yields(std::size_t culprit, Refinement& refinement) {
    constexpr double kFactor = 2;
    constexpr int kMostTimes = 5;
    if (!wasBad_[culprit]) {
      refinement.dropAll(culprit);
      return true;
    }
    if (softened_[culprit] == kMostTimes) return false;
    ++softened_[culprit];
    refinement.soften(culprit, kFactor);
    return true;
  }

  /// The face itself and those that share an edge with it.
  std::vector<std::size_t> beside(std::size_t i) const {
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(task_.model.face(task_.faces[i]), TopAbs_EDGE, edges);
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < task_.faces.size(); ++k)
      for (TopExp_Explorer it(task_.model.face(task_.faces[k]), TopAbs_EDGE); it.More(); it.Next())
        if (edges.Contains(it.Current())) {
          found.push_back(k);
          break;
        }
    return found;
  }

  const RetryTask& task_;
  std::vector<bool> wasBad_;
  std::vector<int> softened_;
};

class Retries {
 public:
  explicit Retries(const RetryTask& task) : task_(task) {}

  void retry(FaceMeshes& state) {
    constexpr int kMostRounds = 12;
    Refinement refinement(task_.options);
    FaceMeshes best;
    std::vector<bool> isHopeless(task_.faces.size(), false);
    std::vector<bool> wasTried(task_.faces.size(), false);
    std::vector<int> failures(task_.faces.size(), 0);
    std::vector<std::size_t> dropped;  // faces for which shorter edges were of no use
    Neighbors neighbors(task_, state.meshes);
    const double mostEffort = Retries::mostEffort(state);
    double effort = 0;
    task_.join(state);
    for (int round = 0; round < kMostRounds && !task_.options.stop.stop_requested(); ++round) {
      const std::vector<std::size_t> poor = worthAnotherTry(state, isHopeless, wasTried);
      if ((poor.empty() && dropped.empty()) || effort > mostEffort) break;
      for (const std::size_t i : poor) {
        std::vector<SizeSource> places = placesOf(state, i);
        if (failed(state.meshes[i]) && !wasTried[i])
          std::ranges::move(sizesInside(i), std::back_inserter(places));
        refinement.add(i, places);
        wasTried[i] = true;
      }
      std::vector<std::size_t> again;
      std::ranges::set_union(poor, dropped, std::back_inserter(again));
      FaceMeshes next = refined(state, again, refinement.options(), effort);
      if (task_.options.stop.stop_requested()) break;
      task_.join(next);
      dropped.clear();
      for (const std::size_t i : poor) {
        if (isWorthwhile(state, next, i, failures[i])) continue;
        isHopeless[i] = true;
        dropped.push_back(i);
        const bool isInVain = failed(next.meshes[i]) || crossingsAt(next, i) > 0;
        isInVain ? refinement.dropAll(i) : refinement.dropLast(i);
      }
      neighbors.spare(next, refinement, isHopeless, dropped);
      if (best.meshes.empty() || isBetter(state, best)) best = std::move(state);
      state = std::move(next);
    }
    if (!best.meshes.empty() && !isBetter(state, best)) state = std::move(best);
    lean(state);
  }

 private:
  /// The last way for faces that failed; without those that then cross others.
  void lean(FaceMeshes& state) const {
    std::vector<std::pair<std::size_t, FaceMesh>> before;
    for (std::size_t i = 0; i < state.meshes.size() && !task_.options.stop.stop_requested(); ++i) {
      if (!failed(state.meshes[i])) continue;
      FaceMesh was = std::move(state.meshes[i]);
      task_.meshLeaning(i, state);
      if (failed(state.meshes[i]))
        state.meshes[i] = std::move(was);
      else
        before.emplace_back(i, std::move(was));
    }
    if (before.empty()) return;
    task_.join(state);
    for (auto& [i, was] : before) {
      if (crossingsAt(state, i) > 0) {
        state.meshes[i] = std::move(was);
      } else {
        std::vector<std::string>& steps = state.meshes[i].report.attempts;
        steps.push_back("elements that lean against the surface");
      }
    }
    task_.join(state);
  }

  static std::vector<std::size_t> worthAnotherTry(const FaceMeshes& state,
                                                  const std::vector<bool>& isHopeless,
                                                  const std::vector<bool>& wasTried) {
    std::vector<std::size_t> poor;
    for (std::size_t i = 0; i < state.meshes.size(); ++i) {
      const FaceTrouble& trouble = state.meshes[i].trouble;
      if (isHopeless[i]) continue;
      const bool isWorthIt = !trouble.places.empty() && (trouble.isBad || !wasTried[i]);
      if (isWorthIt || crossingsAt(state, i) > 0) poor.push_back(i);
    }
    return poor;
  }

  /// Tries may cost some times as much as the mesh, but no more than about ten seconds. Goes by
  /// candidates of the front.
  static double mostEffort(const FaceMeshes& state) {
    constexpr double kShare = 3, kMost = 6'000'000, kAlways = 2'000'000;
    double candidates = 0;
    for (const FaceMesh& mesh : state.meshes) candidates += static_cast<double>(mesh.effort);
    return std::min(kShare * candidates, kMost) + kAlways;
  }
  /// What it costs to mesh a face again besides these.
  static constexpr double kForEachFace = 1000;

  /// A face that failed may fail again, and shorter edges are dearer.
  static std::size_t mostCandidates(const FaceMesh& before) {
    constexpr std::size_t kAlways = 300'000, kTimes = 2;
    return failed(before) ? kAlways + kTimes * before.effort
                          : std::numeric_limits<std::size_t>::max();
  }

  /// A front may be stuck because sizes by curvature change faster than it can follow.
  std::vector<SizeSource> sizesInside(std::size_t i) const {
    if (task_.options.sizes.elementsPerTurn > 0) return {};  // they are spread already
    return geometry::sizesInside(task_.model, task_.faces[i], task_.options.sizes);
  }

  static std::ptrdiff_t crossingsAt(const FaceMeshes& state, std::size_t i) {
    const int face = state.meshes[i].report.id;
    return std::ranges::count_if(state.crossings, [&](const Crossing& crossing) {
      return std::ranges::count(crossing.faces, face) > 0;
    });
  }

  /// Those of the trouble; and where elements cross, half as long as these.
  static std::vector<SizeSource> placesOf(const FaceMeshes& state, std::size_t i) {
    constexpr double kFiner = 0.5;
    constexpr std::size_t kMostCrossed = 1000;
    const int face = state.meshes[i].report.id;
    std::vector<SizeSource> places = state.meshes[i].trouble.places;
    const std::size_t most = places.size() + kMostCrossed;
    for (const Crossing& crossing : state.crossings)
      for (std::size_t k = 0; k < 2 && places.size() < most; ++k) {
        if (crossing.faces[k] != face) continue;
        const auto corners = state.joined.elements[crossing.elements[k].value].vertices();
        double longest = 0;
        for (const VertexId a : corners)
          for (const VertexId b : corners)
            longest = std::max(
                longest, distance(state.joined.vertices[a.value], state.joined.vertices[b.value]));
        places.push_back({crossing.place, kFiner * longest});
      }
    return places;
  }

  /// Whether a face should be tried once more after `next`.
  static bool isWorthwhile(const FaceMeshes& state, const FaceMeshes& next, std::size_t i,
                           int& failures) {
    constexpr double kGain = 0.9;
    constexpr int kMostFailures = 6, kMostCrossed = 2;
    const FaceMesh &before = state.meshes[i], &after = next.meshes[i];
    if (failed(after)) return ++failures < kMostFailures;
    const auto crossed = static_cast<double>(crossingsAt(state, i));
    const auto crosses = static_cast<double>(crossingsAt(next, i));
    if (crosses > 0) return crosses < kGain * crossed || ++failures < kMostCrossed;
    return failed(before) || crossed > 0 ||
           after.trouble.poorness < kGain * before.trouble.poorness;
  }

  static bool isBetter(const FaceMeshes& one, const FaceMeshes& other) {
    const auto rank = [](const FaceMeshes& state) {
      // The fewest elements, if all else is equal.
      std::tuple<std::size_t, std::size_t, double, std::size_t> sum{0, 0, 0, 0};
      for (const FaceMesh& mesh : state.meshes) {
        if (failed(mesh))
          ++std::get<0>(sum);
        else
          std::get<2>(sum) += mesh.trouble.poorness;
        if (mesh.trouble.hasBadAngle) ++std::get<1>(sum);
        std::get<3>(sum) += mesh.elements.size();
      }
      std::get<0>(sum) += facesThatCross(state.crossings, {}).size();
      return sum;
    };
    return rank(one) < rank(other);
  }

  /// The edges divided anew, the faces meshed anew that are at fault or lie at edges that changed.
  FaceMeshes refined(const FaceMeshes& state, const std::vector<std::size_t>& poor,
                     const ModelMeshingOptions& options, double& effort) const {
    FaceMeshes next;
    next.divided =
        divideEdges(task_.model, options.sizes, options.threads, options.stop, options.edgePoints);
    const DivisionChange change = compare(state.divided, next.divided);
    next.meshes.resize(task_.faces.size());
    std::vector<std::size_t> again;
    for (std::size_t i = 0; i < task_.faces.size(); ++i) {
      if (std::ranges::binary_search(poor, i) || touches(task_.faces[i], change)) {
        again.push_back(i);
        continue;
      }
      next.meshes[i] = state.meshes[i];
      for (std::uint32_t& point : next.meshes[i].boundary) point = change.newIndex[point];
    }
    forEachInParallel(again.size(), options.threads, [&](std::size_t k) {
      task_.mesh(again[k], options, mostCandidates(state.meshes[again[k]]), next);
      tellOfRetry(state, again[k], next.meshes[again[k]]);
    });
    for (const std::size_t i : again)
      effort += static_cast<double>(next.meshes[i].effort) + kForEachFace;
    return next;
  }

  /// What a face that is meshed again has behind it.
  static void tellOfRetry(const FaceMeshes& state, std::size_t i, FaceMesh& after) {
    const FaceMesh& before = state.meshes[i];
    std::vector<std::string> steps = before.report.attempts;
    if (failed(before)) steps.push_back(before.report.reason);
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

  bool touches(int face, const DivisionChange& change) const {
    for (TopExp_Explorer it(task_.model.face(face), TopAbs_EDGE); it.More(); it.Next()) {
      const int edge = task_.model.edges.FindIndex(it.Current());
      if (change.isChanged[static_cast<std::size_t>(edge) - 1]) return true;
    }
    return false;
  }

  const RetryTask& task_;
};

}  // namespace

void retryPoorFaces(const RetryTask& task, FaceMeshes& state) { Retries(task).retry(state); }

}  // namespace af2::geometry
