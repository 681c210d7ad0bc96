#include "engine/optimize/quad_search.h"

#include <algorithm>

#include "engine/optimize/ideal_angles.h"
#include "engine/optimize/vertex_news.h"

namespace af2 {
namespace {

/// Elements of this scaled Jacobian are good enough for smoothing to do the rest.
constexpr double kGoodJacobian = 0.55;

/// The patches with the lowest energies, in order; ties go to the earlier one.
class BestPatches {
 public:
  explicit BestPatches(std::size_t most) : most_(most) {}
  void offer(const QuadPatch& patch) {
    if (patches_.size() == most_ && patch.energy() >= patches_.back().energy()) return;
    patches_.insert(std::ranges::upper_bound(patches_, patch.energy(), {}, &QuadPatch::energy),
                    patch);
    if (patches_.size() > most_) patches_.pop_back();
  }
  std::vector<QuadPatch> take() { return std::exchange(patches_, {}); }

 private:
  std::size_t most_;
  std::vector<QuadPatch> patches_;
};

class QuadSearch {
 public:
  explicit QuadSearch(PatchEditor& editor)
      : editor_(editor), news_(editor.topology().mesh().vertices.size()) {}

  /// One look at each irregular vertex whose surroundings have changed since the last one; first at
  /// those that are far from regular: their neighbours could only make them a little better.
  std::size_t pass(int depth, const std::stop_token& stop) {
    return passOver(2 * kRightAngle, depth, stop) + passOver(1, depth, stop);
  }

 private:
  std::size_t passOver(int leastIrregularity, int depth, const std::stop_token& stop) {
    std::size_t applied = 0;
    for (std::size_t v = 0; v < editor_.topology().mesh().vertices.size(); ++v) {
      const VertexId seed(v);
      while (editor_.irregularity(seed) >= leastIrregularity && news_.isNews(seed)) {
        if (stop.stop_requested()) return applied;
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

/// The energy may rise on the way as much as two irregular vertices have.
std::vector<QuadPatch> betterPatches(const QuadPatch& start, int depth) {
  constexpr std::size_t kGoOn = 14, kResults = 6, kTrials = 2000, kTrialsInDepth = 9000;
  constexpr int kDetour = 18;
  BestPatches results(kResults);
  std::vector<QuadPatch> level{start};
  for (int d = 1; d <= depth; ++d) {
    std::size_t trials = d <= 2 ? kTrials : kTrialsInDepth;
    BestPatches next(kGoOn);
    for (const QuadPatch& patch : level) {
      const auto tryAct = [&](const QuadPatch::Act& act) {
        if (trials == 0) return;
        --trials;
        const int energy = patch.energyAfter(act);
        const bool isBetter = energy < start.energy();
        const bool goesOn = d < depth && energy <= start.energy() + kDetour;
        if ((!isBetter && !goesOn) || !patch.allows(act)) return;
        QuadPatch changed = patch;
        changed.apply(act);
        if (isBetter) results.offer(changed);
        if (goesOn) next.offer(changed);
      };
      for (std::size_t v = 0; v < patch.vertexCount(); ++v) {
        const auto vertex = static_cast<QuadPatch::Vertex>(v);
        if (v == 0 || (patch.isTouched(vertex) && patch.energyAt(vertex) > 0))
          forEachAct(patch, vertex, tryAct);
      }
    }
    level = next.take();
  }
  return results.take();
}

std::size_t searchQuads(PatchEditor& editor, int depth, const std::stop_token& stop) {
  constexpr int kMaxPasses = 3;
  std::size_t applied = 0;
  for (int d = 1; d <= depth; ++d) {
    QuadSearch search(editor);
    for (int pass = 0; pass < kMaxPasses; ++pass) {
      const std::size_t more = search.pass(d, stop);
      applied += more;
      if (more == 0) break;
    }
  }
  return applied;
}

}  // namespace af2
