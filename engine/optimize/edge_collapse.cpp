#include "engine/optimize/edge_collapse.h"

#include <cstdint>
#include <vector>

#include "engine/mesh/element_shape.h"
#include "engine/mesh/triangle_grades.h"

namespace af2 {
namespace {

/// A vertex with at most this many triangles is removed if the remaining triangles are fair.
constexpr int kFewTriangles = 4;
constexpr double kFairDistortion = 1.5;
/// A collapse that clearly improves a triangle worse than this is worth while.
constexpr double kBadDistortion = 2.5;
constexpr double kClearGain = 0.8;

class Collapser {
 public:
  Collapser(MeshTopology& topology, ActRecorder* recorder)
      : topology_(topology), recorder_(recorder), mayBeBad_(topology.mesh().vertices.size(), 0) {
    for (std::size_t e = 0; e < topology.mesh().elements.size(); ++e) look(e);
  }

  bool tryCollapse(VertexId v) {
    const bool hasFew = topology_.valence(v) <= kFewTriangles;
    if (!hasFew && !mayBeBad_[v.value]) return false;
    if (topology_.valence(v) == 0 || !collectStar(v)) return false;
    const double before = worstBefore();
    if (!hasFew && before < kBadDistortion) return false;

    Corner best;
    double bestWorst = INFINITY;
    for (Corner side : star_) {
      if (!isPossible(side)) continue;
      const double after = worstAfter(side);
      if (after < bestWorst) bestWorst = after, best = side;
    }
    const bool isWorthwhile =
        bestWorst < kClearGain * before || (hasFew && bestWorst < kFairDistortion);
    if (best.isNone() || !isWorthwhile) return false;
    if (recorder_) recorder_->begin(star_, v);
    topology_.collapse(best);
    if (recorder_) recorder_->end(FinishAct::Kind::Collapse);
    for (Corner c : star_)
      if (!topology_.isDead(c.element())) look(c.element());
    return true;
  }

 private:
  /// Marks the vertices of a bad triangle.
  void look(std::size_t e) {
    if (isKnownGood(topology_, e)) return;
    const auto corners = topology_.mesh().elements[e].vertices();
    if (topology_.isDead(e) || corners.size() != 3 || isGood(topology_, e)) return;
    if (isPlainlyBelow(kBadDistortion, at(corners[0]), at(corners[1]), at(corners[2]))) return;
    for (VertexId v : corners) mayBeBad_[v.value] = 1;
  }

  const SurfacePoint& at(VertexId v) const { return topology_.mesh().vertices[v.value]; }
  VertexId endOf(Corner side) const { return topology_.vertexAt(topology_.next(side)); }

  /// The corners of an inner vertex that has only triangles.
  bool collectStar(VertexId v) {
    star_.clear();
    const Corner first = topology_.cornerOf(v);
    Corner c = first;
    do {
      if (topology_.sizeOf(c) != 3) return false;
      star_.push_back(c);
      c = topology_.aroundVertex(c);
    } while (!c.isNone() && c != first);
    return c == first;
  }

  /// Whether the result is a valid mesh: the ends have no common neighbours except the two beside
  /// the edge, and those two keep enough triangles.
  bool isPossible(Corner side) const {
    const VertexId to = endOf(side);
    const VertexId left = topology_.vertexAt(topology_.previous(side));
    const VertexId right = topology_.vertexAt(topology_.previous(topology_.across(side)));
    for (VertexId v : {left, right})
      if (topology_.valence(v) <= (topology_.isFixed(v) ? 1 : 3)) return false;
    for (Corner c : star_) {
      const VertexId w = endOf(c);
      if (w != to && w != left && w != right && topology_.areJoined(to, w)) return false;
    }
    return true;
  }

  double worstBefore() const {
    double worst = 0;
    for (Corner c : star_)
      worst = std::max(worst, distortion(topology_.vertexAt(c), endOf(c),
                                         topology_.vertexAt(topology_.previous(c))));
    return worst;
  }

  double worstAfter(Corner side) const {
    const VertexId to = endOf(side);
    double worst = 0;
    for (Corner c : star_) {
      const VertexId next = endOf(c), previous = topology_.vertexAt(topology_.previous(c));
      if (next != to && previous != to) worst = std::max(worst, distortion(to, next, previous));
    }
    return worst;
  }

  double distortion(VertexId a, VertexId b, VertexId c) const {
    return triangleDistortion(at(a), at(b), at(c));
  }

  MeshTopology& topology_;
  ActRecorder* recorder_;
  std::vector<Corner> star_;
  std::vector<std::uint8_t> mayBeBad_;  ///< by vertex: a triangle there is, or was, bad
};

}  // namespace

std::size_t collapseEdges(MeshTopology& topology, ActRecorder* recorder, const WorkWatch& watch) {
  Collapser collapser(topology, recorder);
  std::size_t collapses = 0;
  const std::size_t first = topology.fixedCount();
  for (std::size_t v = first; v < topology.mesh().vertices.size(); ++v) {
    if (watch.mustStopAt(v - first)) break;
    collapses += collapser.tryCollapse(VertexId(v));
  }
  return collapses;
}

}  // namespace af2
