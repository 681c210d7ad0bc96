#include "engine/optimize/quad_tidying.h"

#include <algorithm>

#include "engine/optimize/quad_changes.h"
#include "engine/optimize/triangle_pairs.h"

namespace af2 {
namespace {

/// New elements may be worse than this only where an old one was worse, too: smoothing follows.
constexpr Leniency kFair{2.5, 1};
/// Elements better than this are left unchanged if all their vertices are regular.
constexpr double kGoodQuad = 1.3;
/// Elements worse than this justify a collapse that turns quadrilaterals into triangles.
constexpr double kBadQuad = 3;

/// Offers changes at one element and its neighbours.
class Tidier {
 public:
  Tidier(QuadChanges& changes, const WorkWatch& watch)
      : changes_(changes), topology_(changes.topology()), watch_(watch) {}

  std::size_t pass() {
    std::size_t changes = 0;
    for (std::size_t e = 0; e < changes_.elementCount(); ++e) {
      if (watch_.mustStopAt(e)) break;
      while (isWorthALook(e) && tryBest(e)) ++changes;
    }
    return changes;
  }

 private:
  VertexId endOf(Corner c) const { return topology_.vertexAt(topology_.next(c)); }
  bool isInner(Corner c) const { return !topology_.isFixed(topology_.vertexAt(c)); }

  bool isWorthALook(std::size_t e) const {
    if (topology_.isDead(e) || !changes_.isOpen(e) || !changes_.isNews(e)) return false;
    const Element& element = changes_.elementAt(e);
    if (!element.isQuad()) return true;
    for (const VertexId v : element.vertices())
      if (!changes_.isRegular(v)) return true;
    return changes_.distortionAt(e) > kGoodQuad;
  }

  bool tryBest(std::size_t e) {
    changes_.look(e);
    const auto n = static_cast<std::size_t>(changes_.elementAt(e).size());
    const bool isBad = changes_.distortionAt(e) > kBadQuad;
    for (std::size_t i = 0; i < n; ++i) {
      const Corner c(e, i);
      const VertexId from = topology_.vertexAt(c), to = endOf(c);
      if (!topology_.across(c).isNone()) offerResplits(c);
      if (n == 4 && isInner(c)) offerDiagonalCollapse(c);
      for (std::size_t k = 0; n == 4 && k < i; ++k) offerTwoForThree(Corner(e, k), c);
      if (n == 4 && i < 2 && isBad) offerSplit(c);
      if (isBad && !topology_.isFixed(from)) offerMerge(from, to);
      if (isBad && !topology_.isFixed(to)) offerMerge(to, from);
    }
    return changes_.apply(FinishAct::Kind::Replacement);
  }

  /// Two adjacent elements become one quadrilateral, or two others with the same outline.
  void offerResplits(Corner side) {
    const Corner other = topology_.across(side);
    std::vector<VertexId> ring = changes_.from(topology_.next(side));
    const std::vector<VertexId> beyond = changes_.from(topology_.next(other));
    ring.insert(ring.end(), beyond.begin() + 1, beyond.end() - 1);
    if (!areDifferent(ring)) return;
    const std::vector<std::size_t> places{side.element(), other.element()};
    if (ring.size() == 4) return changes_.offer({places, {elementOf(ring)}}, kFair);
    offerHalves(places, ring);
  }

  /// A quadrilateral with triangles at two of its sides becomes two quadrilaterals.
  void offerTwoForThree(Corner one, Corner other) {
    const Corner apart[] = {topology_.across(one), topology_.across(other)};
    std::vector<VertexId> ring = changes_.from(Corner(one.element(), 0));
    for (const Corner& beyond : {apart[1], apart[0]}) {  // the later side first
      if (beyond.isNone() || topology_.sizeOf(beyond) != 3) return;
      const std::size_t i = topology_.across(beyond).index();
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                  topology_.vertexAt(topology_.previous(beyond)));
    }
    if (areDifferent(ring))
      offerHalves({one.element(), apart[0].element(), apart[1].element()}, ring);
  }

  /// Splits a ring of five or six vertices in two in all ways that do not give two triangles.
  void offerHalves(const std::vector<std::size_t>& places, std::vector<VertexId> ring) {
    const std::size_t across = ring.size() - 3;
    for (std::size_t i = 0; i < (ring.size() == 5 ? 5u : 3u); ++i) {
      std::rotate(ring.begin(), ring.begin() + 1, ring.end());
      if (topology_.areJoined(ring[0], ring[across])) continue;
      std::vector<VertexId> rest(ring.begin() + static_cast<std::ptrdiff_t>(across), ring.end());
      rest.push_back(ring[0]);
      changes_.offer({places, {elementOf(std::span(ring).first(across + 1)), elementOf(rest)}},
                     kFair);
    }
  }

  /// A quadrilateral becomes two triangles.
  void offerSplit(Corner c) {
    const std::vector<VertexId> v = changes_.from(c);
    if (topology_.areJoined(v[0], v[2])) return;
    changes_.offer({{c.element()}, {{{v[0], v[1], v[2], {}}}, {{v[0], v[2], v[3], {}}}}}, kFair);
  }

  /// Removes a quadrilateral: one of its vertices moves to the opposite one.
  void offerDiagonalCollapse(Corner c) {
    for (const Corner beside : {topology_.next(c), topology_.previous(c)})
      if (topology_.valence(topology_.vertexAt(beside)) <= (isInner(beside) ? 3 : 1)) return;
    offerMerge(topology_.vertexAt(c), topology_.vertexAt(topology_.next(topology_.next(c))));
  }

  /// Moves an inner vertex to another vertex of an element. Of the elements that have both,
  /// triangles vanish; quadrilaterals become triangles or, if the two are opposite, vanish as well.
  void offerMerge(VertexId gone, VertexId into) {
    Change change;
    std::vector<VertexId> shared, others;  // neighbours of `gone`, in elements with `into` and not
    const Corner first = topology_.cornerOf(gone);
    Corner c = first;
    do {
      if (c.isNone() || !changes_.isOpen(c.element())) return;
      change.places.push_back(c.element());
      std::vector<VertexId> ring = changes_.from(c);
      const bool hasBoth = std::ranges::find(ring, into) != ring.end();
      for (const VertexId v : {ring[1], ring.back()}) (hasBoth ? shared : others).push_back(v);
      if (hasBoth && ring.size() == 4 && ring[2] == into) ring.clear();
      std::ranges::replace(ring, gone, into);
      ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
      if (!ring.empty() && ring.front() == ring.back()) ring.pop_back();
      if (ring.size() >= 3) change.elements.push_back(elementOf(ring));
      c = topology_.aroundVertex(c);
    } while (c != first);
    for (const VertexId v : others)
      if (std::ranges::find(shared, v) == shared.end() && topology_.areJoined(into, v)) return;
    for (const Element& element : change.elements)
      if (!areDifferent(element.vertices())) return;
    changes_.offer(std::move(change), kFair);
  }

  QuadChanges& changes_;
  const MeshTopology& topology_;
  const WorkWatch& watch_;
};

}  // namespace

std::size_t tidyQuads(MeshTopology& topology, const std::vector<double>& anglesAtFixed,
                      std::optional<std::uint16_t> closingRule, ActRecorder* recorder,
                      MayAddTriangles triangles, const WorkWatch& watch) {
  constexpr int kMaxPasses = 3;
  QuadChanges changes(topology, anglesAtFixed, closingRule, recorder);
  if (triangles == MayAddTriangles::No) changes.keepQuads();
  Tidier tidier(changes, watch);
  std::size_t count = 0;
  for (int i = 0; i < kMaxPasses; ++i) {
    const std::size_t more = tidier.pass();
    count += more;
    if (more == 0) break;
  }
  return count + pairTriangles(changes, watch);
}

}  // namespace af2
