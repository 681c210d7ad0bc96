#include "engine/optimize/quad_search.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/optimize/ideal_angles.h"
#include "engine/optimize/vertex_news.h"

namespace af2 {
namespace {

/// Elements of this scaled Jacobian are good enough for smoothing to do the rest.
constexpr double kGoodJacobian = 0.55;

/// The patches with the lowest costs, in order; ties go to the earlier one.
class BestPatches {
 public:
  explicit BestPatches(std::size_t most) : most_(most) {}
  void offer(const QuadPatch& patch, int cost) {
    if (costs_.size() == most_ && cost >= costs_.back()) return;
    const auto place = std::ranges::upper_bound(costs_, cost) - costs_.begin();
    costs_.insert(costs_.begin() + place, cost);
    patches_.insert(patches_.begin() + place, patch);
    if (costs_.size() <= most_) return;
    costs_.pop_back();
    patches_.pop_back();
  }
  std::vector<QuadPatch> take() {
    costs_.clear();
    return std::exchange(patches_, {});
  }

 private:
  std::size_t most_;
  std::vector<int> costs_;
  std::vector<QuadPatch> patches_;
};

/// Calls found(patch) for the results of sequences of acts whose energies are at most `mostEnergy`.
/// On the way, the energy may rise as much as two irregular vertices have.
template <class Found>
void forEachSequence(const QuadPatch& start, int depth, int mostEnergy, const Found& found) {
  constexpr std::size_t kGoOn = 14, kTrials = 2000, kTrialsInDepth = 9000;
  constexpr int kDetour = 18;
  std::vector<QuadPatch> level{start};
  for (int d = 1; d <= depth; ++d) {
    std::size_t trials = d <= 2 ? kTrials : kTrialsInDepth;
    BestPatches next(kGoOn);
    for (const QuadPatch& patch : level) {
      const auto tryAct = [&](const QuadPatch::Act& act) {
        if (trials == 0) return;
        --trials;
        const int energy = patch.energyAfter(act);
        const bool isFound = energy <= mostEnergy;
        const bool goesOn = d < depth && energy <= start.energy() + kDetour;
        if ((!isFound && !goesOn) || !patch.allows(act)) return;
        QuadPatch changed = patch;
        changed.apply(act);
        if (isFound) found(changed);
        if (goesOn) next.offer(changed, energy);
      };
      for (std::size_t v = 0; v < patch.vertexCount(); ++v) {
        const auto vertex = static_cast<QuadPatch::Vertex>(v);
        if (v == 0 || (patch.isTouched(vertex) && patch.energyAt(vertex) > 0))
          forEachAct(patch, vertex, tryAct);
      }
    }
    level = next.take();
  }
}

constexpr std::size_t kResults = 6;

class QuadSearch {
 public:
  explicit QuadSearch(PatchEditor& editor)
      : editor_(editor), news_(editor.topology().mesh().vertices.size()) {}

  /// One look at each irregular vertex whose surroundings have changed since the last one; first at
  /// those that are far from regular: their neighbours could only make them a little better.
  std::size_t pass(int depth, const WorkWatch& watch) {
    return passOver(2 * kRightAngle, depth, watch) + passOver(1, depth, watch);
  }

 private:
  std::size_t passOver(int leastIrregularity, int depth, const WorkWatch& watch) {
    std::size_t applied = 0;
    for (std::size_t v = 0; v < editor_.topology().mesh().vertices.size(); ++v) {
      const VertexId seed(v);
      while (editor_.irregularity(seed) >= leastIrregularity && news_.isNews(seed)) {
        if (watch.mustStop()) return applied;
        news_.look(seed);
        if (!improve(seed, depth)) break;
        ++applied;
      }
    }
    return applied;
  }

  bool improve(VertexId seed, int depth) {
    if (!editor_.take(seed)) return false;
    const std::vector<QuadPatch> better = betterPatches(editor_.patch(), depth);
    if (better.empty()) return false;
    const std::optional<PatchJacobians> before = editor_.jacobians();
    if (!before) return false;
    const PatchJacobians wanted{std::min(kGoodJacobian, before->least)};
    for (const QuadPatch& patch : better)
      if (editor_.putBack(patch, wanted, FinishAct::Kind::Search)) {
        news_.noteChange(editor_.vertices(), editor_.topology().mesh().vertices.size());
        return true;
      }
    return false;
  }

  PatchEditor& editor_;
  VertexNews news_;
};

}  // namespace

std::vector<QuadPatch> betterPatches(const QuadPatch& start, int depth) {
  BestPatches results(kResults);
  forEachSequence(start, depth, start.energy() - 1,
                  [&](const QuadPatch& patch) { results.offer(patch, patch.energy()); });
  return results.take();
}

int irregularityAtBoundary(const QuadPatch& patch) {
  constexpr int kFar = 3;
  constexpr std::array<int, kFar + 1> kWeights{0, 3, 1, 0};  // by the edges from the boundary
  std::array<int, QuadPatch::kMaxVertices> edges{};
  for (std::size_t v = 0; v < patch.vertexCount(); ++v)
    edges[v] = patch.isFixed(static_cast<QuadPatch::Vertex>(v)) ? 0 : kFar;
  for (int ring = 0; ring + 1 < kFar; ++ring)
    for (std::size_t e = 0; e < patch.elementCount(); ++e) {
      if (!patch.isAlive(e)) continue;
      const auto corners = patch.cornersAt(e);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        int &one = edges[corners[i]], &other = edges[corners[(i + 1) % corners.size()]];
        if (one == ring) other = std::min(other, ring + 1);
        if (other == ring) one = std::min(one, ring + 1);
      }
    }
  int sum = 0;
  for (std::size_t v = 0; v < patch.vertexCount(); ++v)
    if (patch.energyAt(static_cast<QuadPatch::Vertex>(v)) > 0)
      sum += kWeights[static_cast<std::size_t>(edges[v])];
  return sum;
}

std::vector<QuadPatch> inwardPatches(const QuadPatch& start, int depth) {
  const int before = irregularityAtBoundary(start);
  BestPatches results(kResults);
  if (before > 0)
    forEachSequence(start, depth, start.energy(), [&](const QuadPatch& patch) {
      const int after = irregularityAtBoundary(patch);
      if (after < before) results.offer(patch, after);
    });
  return results.take();
}

std::size_t searchQuads(PatchEditor& editor, int depth, const WorkWatch& watch) {
  constexpr int kMaxPasses = 3;
  std::size_t applied = 0;
  for (int d = 1; d <= depth; ++d) {
    QuadSearch search(editor);
    for (int pass = 0; pass < kMaxPasses; ++pass) {
      const std::size_t more = search.pass(d, watch);
      applied += more;
      if (more == 0) break;
    }
  }
  return applied;
}

std::size_t moveInward(PatchEditor& editor, int depth, const WorkWatch& watch) {
  std::size_t applied = 0;
  for (std::size_t v = 0; v < editor.topology().mesh().vertices.size(); ++v) {
    const VertexId seed(v);
    if (watch.mustStop()) return applied;
    if (editor.irregularity(seed) == 0 || !editor.take(seed)) continue;
    const std::vector<QuadPatch> inward = inwardPatches(editor.patch(), depth);
    if (inward.empty()) continue;
    const std::optional<PatchJacobians> before = editor.jacobians();
    if (!before) continue;
    const PatchJacobians wanted = acceptableAfter(*before);
    const auto putBack = [&](const QuadPatch& patch) {
      return editor.putBack(patch, wanted, FinishAct::Kind::Search);
    };
    applied += std::ranges::any_of(inward, putBack) ? 1 : 0;
  }
  return applied;
}

}  // namespace af2
