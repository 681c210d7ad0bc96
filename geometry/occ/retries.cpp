#include "geometry/occ/retries.h"

#include <TopExp_Explorer.hxx>
#include <algorithm>
#include <string>
#include <utility>

#include "geometry/occ/parallel.h"
#include "geometry/occ/refinement.h"

namespace af2::geometry {

namespace {

class Retries {
 public:
  explicit Retries(const RetryTask& task) : task_(task) {}

  void retry(FaceMeshes& state) {
    constexpr int kMostRounds = 6;
    Refinement refinement(task_.options);
    FaceMeshes best;
    std::vector<bool> isHopeless(task_.faces.size(), false);
    std::vector<int> failures(task_.faces.size(), 0);
    double effort = 0;
    for (int round = 0; round < kMostRounds && !task_.options.stop.stop_requested(); ++round) {
      const std::vector<std::size_t> poor = worthAnotherTry(state, isHopeless);
      if (poor.empty() || effort > mostEffort(state)) break;
      for (const std::size_t i : poor) refinement.add(state.meshes[i].trouble.places);
      FaceMeshes next = refined(state, poor, refinement.options(), effort);
      if (task_.options.stop.stop_requested()) break;
      for (const std::size_t i : poor)
        if (!isWorthwhile(state.meshes[i], next.meshes[i], failures[i])) isHopeless[i] = true;
      if (best.meshes.empty() || isBetter(state, best)) best = std::move(state);
      state = std::move(next);
    }
    if (!best.meshes.empty() && !isBetter(state, best)) state = std::move(best);
  }

 private:
  static bool failed(const FaceMesh& mesh) { return mesh.report.status == FaceStatus::Failed; }

  static std::vector<std::size_t> worthAnotherTry(const FaceMeshes& state,
                                                  const std::vector<bool>& isHopeless) {
    std::vector<std::size_t> poor;
    for (std::size_t i = 0; i < state.meshes.size(); ++i) {
      const FaceMesh& mesh = state.meshes[i];
      if (!mesh.trouble.places.empty() && !isHopeless[i]) poor.push_back(i);
    }
    return poor;
  }

  /// Tries may cost some times as much as the mesh, but not more.
  static double mostEffort(const FaceMeshes& state) {
    constexpr double kShare = 3, kAlways = 200'000;
    double elements = 0;
    for (const FaceMesh& mesh : state.meshes) elements += static_cast<double>(mesh.elements.size());
    return kShare * elements + kAlways;
  }

  /// Whether a face should be tried once more after `after`.
  static bool isWorthwhile(const FaceMesh& before, const FaceMesh& after, int& failures) {
    constexpr double kGain = 0.9;
    constexpr int kMostFailures = 4;
    if (failed(after)) return ++failures < kMostFailures;
    return failed(before) || after.trouble.poorness < kGain * before.trouble.poorness;
  }

  static bool isBetter(const FaceMeshes& one, const FaceMeshes& other) {
    const auto rank = [](const FaceMeshes& state) {
      std::pair<std::size_t, double> sum{0, 0};
      for (const FaceMesh& mesh : state.meshes) {
        if (failed(mesh))
          ++sum.first;
        else
          sum.second += mesh.trouble.poorness;
      }
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
      task_.mesh(again[k], options, next);
      tellOfRetry(state.meshes[again[k]], next.meshes[again[k]]);
    });
    for (const std::size_t i : again)
      effort += static_cast<double>(
                    std::max(state.meshes[i].elements.size(), next.meshes[i].elements.size())) +
                1000;
    return next;
  }

  /// What a face that is meshed again has behind it.
  static void tellOfRetry(const FaceMesh& before, FaceMesh& after) {
    std::vector<std::string> steps = before.report.attempts;
    if (failed(before)) steps.push_back(before.report.reason);
    const std::size_t places = before.trouble.places.size();
    if (places > 0) steps.push_back("shorter edges at " + std::to_string(places) + " places");
    std::vector<std::string>& own = after.report.attempts;
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
