#include "engine/optimize/edge_swap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "engine/mesh/element_shape.h"
#include "engine/mesh/triangle_grades.h"

namespace af2 {
namespace {

constexpr int kWantedInside = 6;
/// The least reduction of the sum of squared valence defects by a swap, for each sweep. The most
/// useful swaps come first: where two fronts have met in a row of vertices with four triangles
/// each, only this order gives a regular mesh instead of one that smoothing cannot repair.
constexpr int kMinGains[] = {6, 1};
/// A swap that improves valences may not make a triangle worse than this: smoothing repairs it.
constexpr double kFairAfterSwap = 2.5;

class Swapper {
 public:
  Swapper(MeshTopology& topology, SwapGoal goal, const std::vector<std::uint8_t>& wantedAtFixed,
          ActRecorder* recorder, const WorkWatch& watch)
      : topology_(topology),
        goal_(goal),
        wantedAtFixed_(wantedAtFixed),
        recorder_(recorder),
        watch_(watch) {
    mayChange_.resize(topology.mesh().elements.size());
    if (goal == SwapGoal::Shape)
      lookAtAll();
    else
      markBesideIrregular();
  }

  /// One sweep over all sides in order. Returns the number of swapped sides.
  std::size_t sweep(int leastGain) {
    leastGain_ = leastGain;
    std::size_t swaps = 0;
    for (std::size_t e = 0; e < topology_.mesh().elements.size(); ++e) {
      if (watch_.mustStopAt(e)) break;
      if (!mayChange_[e]) continue;
      for (std::size_t i = 0; i < 3 && !topology_.isDead(e); ++i) {
        const Corner side(e, i);
        // Each side is visited from one of its two elements only.
        if (topology_.across(side).code > side.code) swaps += trySwap(side);
      }
    }
    return swaps;
  }

 private:
  bool trySwap(Corner side) {
    const Corner other = topology_.across(side);
    if (other.isNone()) return false;
    if (goal_ == SwapGoal::Shape && isGood(topology_, side.element()) &&
        isGood(topology_, other.element()))
      return false;
    if (topology_.sizeOf(side) != 3 || topology_.sizeOf(other) != 3) return false;
    const VertexId a = topology_.vertexAt(side), b = topology_.vertexAt(topology_.next(side));
    const VertexId c = topology_.vertexAt(topology_.previous(side));
    const VertexId d = topology_.vertexAt(topology_.previous(other));
    if (topology_.valence(a) <= fewest(a) || topology_.valence(b) <= fewest(b)) return false;
    if (!isWorthwhile(a, b, c, d) || topology_.areJoined(c, d)) return false;
    const std::array places{side.element(), other.element()};
    if (recorder_) recorder_->begin(places);
    topology_.swap(side);
    if (recorder_) recorder_->end(kindOfSwap());
    if (goal_ == SwapGoal::Shape) {
      look(side.element());
      look(other.element());
    }
    return true;
  }

  FinishAct::Kind kindOfSwap() const {
    return goal_ == SwapGoal::Valence ? FinishAct::Kind::SwapForValence
                                      : FinishAct::Kind::SwapForQuality;
  }

  void lookAtAll() {
    for (std::size_t e = 0; e < mayChange_.size(); ++e)
      if (!isKnownGood(topology_, e) && !topology_.isDead(e)) look(e);
  }

  /// Marks a triangle unless it is too good to be swapped.
  void look(std::size_t e) {
    if (!topology_.mesh().elements[e].isQuad() && !isGood(topology_, e)) mark(e);
  }

  /// Marks the elements at vertices that have not as many as they want.
  void markBesideIrregular() {
    const Mesh& mesh = topology_.mesh();
    std::vector<std::uint8_t> isIrregular(mesh.vertices.size());
    for (std::size_t v = 0; v < isIrregular.size(); ++v)
      isIrregular[v] = defect(VertexId(v), 0) > 0;
    for (std::size_t e = 0; e < mayChange_.size(); ++e) {
      if (topology_.isDead(e)) continue;
      const auto& [a, b, c, d] = mesh.elements[e].corners;
      if (isIrregular[a.value] | isIrregular[b.value] | isIrregular[c.value] |
          (!d.isNone() && isIrregular[d.value]))
        mark(e);
    }
  }

  /// The sides of an element are to be looked at, each from either of its two elements.
  void mark(std::size_t e) {
    mayChange_[e] = 1;
    const int size = topology_.mesh().elements[e].size();
    for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i)
      if (const Corner other = topology_.across({e, i}); !other.isNone())
        mayChange_[other.element()] = 1;
  }

  int fewest(VertexId v) const { return topology_.isFixed(v) ? 1 : 3; }
  int defect(VertexId v, int change) const {
    const int wanted = topology_.isFixed(v) ? wantedAtFixed_[v.value] : kWantedInside;
    const int off = topology_.valence(v) + change - wanted;
    return off * off;
  }

  bool isWorthwhile(VertexId a, VertexId b, VertexId c, VertexId d) const {
    if (goal_ == SwapGoal::Valence) {
      const int before = defect(a, 0) + defect(b, 0) + defect(c, 0) + defect(d, 0);
      const int after = defect(a, -1) + defect(b, -1) + defect(c, 1) + defect(d, 1);
      return before - after >= leastGain_ && worst(a, d, c, d, b, c) < kFairAfterSwap;
    }
    const double before = worst(a, b, c, b, a, d);
    if (before < kGoodTriangle) return false;
    return worst(a, d, c, d, b, c) < (1 - 1e-9) * before;
  }

  double worst(VertexId a, VertexId b, VertexId c, VertexId d, VertexId e, VertexId f) const {
    return std::max(distortion(a, b, c), distortion(d, e, f));
  }
  double distortion(VertexId a, VertexId b, VertexId c) const {
    const auto& vertices = topology_.mesh().vertices;
    return triangleDistortion(vertices[a.value], vertices[b.value], vertices[c.value]);
  }

  MeshTopology& topology_;
  SwapGoal goal_;
  int leastGain_ = 1;
  const std::vector<std::uint8_t>& wantedAtFixed_;
  ActRecorder* recorder_;
  const WorkWatch& watch_;
  /// By element: whether some side of it can be worth swapping. Most elements of a mesh are good
  /// and surrounded by regular vertices, so that only few sides have to be looked at. A swap pays
  /// only where several vertices are irregular; where swaps alone have made all of them so, the
  /// next round sees it.
  std::vector<std::uint8_t> mayChange_;
};

}  // namespace

std::vector<std::uint8_t> wantedValences(const std::vector<double>& angles) {
  std::vector<std::uint8_t> wanted;
  for (double angle : angles)
    wanted.push_back(static_cast<std::uint8_t>(std::max(1.0, std::round(angle / (M_PI / 3)))));
  return wanted;
}

std::size_t swapSides(MeshTopology& topology, SwapGoal goal,
                      const std::vector<std::uint8_t>& wantedAtFixed, ActRecorder* recorder,
                      const WorkWatch& watch) {
  Swapper swapper(topology, goal, wantedAtFixed, recorder, watch);
  if (goal == SwapGoal::Shape) return swapper.sweep(0);
  std::size_t swaps = 0;
  for (const int gain : kMinGains) swaps += swapper.sweep(gain);
  return swaps;
}

}  // namespace af2
