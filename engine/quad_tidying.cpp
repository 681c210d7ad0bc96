#include "engine/quad_tidying.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/element_shape.h"

namespace af2 {
namespace {

/// Ideal angles are counted in units of 30 degrees.
constexpr int kFullTurn = 12;
int idealAngle(const Element& element) { return element.isQuad() ? 3 : 2; }

/// What a triangle costs, and what distortion does, in squared units of missing angle.
constexpr double kTriangleCost = 12, kDistortionCost = 3;
/// Elements worse than this may come about only where there was a worse one: smoothing follows.
constexpr double kFairDistortion = 2.5;
/// Elements better than this are left alone if all their vertices are as they should be.
constexpr double kGoodDistortion = 1.3;
/// Worse ones are worth a collapse that makes triangles of quadrilaterals.
constexpr double kBadDistortion = 3;
/// More triangles than these, side by side, are meant to be.
constexpr std::size_t kLargestIsland = 12;

/// Elements that could stand in the place of others.
struct Change {
  std::vector<std::size_t> places;
  std::vector<Element> elements;
};

class Tidier {
 public:
  Tidier(MeshTopology& topology, const std::vector<double>& anglesAtFixed)
      : topology_(topology), wanted_(topology.mesh().vertices.size(), kFullTurn) {
    for (std::size_t v = 0; v < anglesAtFixed.size(); ++v)
      wanted_[v] = std::max(1, static_cast<int>(std::lround(anglesAtFixed[v] / (M_PI / 6))));
    sum_.assign(wanted_.size(), 0);
    changed_.assign(wanted_.size(), 0);
    lookedAt_.assign(mesh().elements.size(), 0);
    for (std::size_t e = 0; e < mesh().elements.size(); ++e) {
      distortion_.push_back(topology_.isDead(e) ? 0 : distortion(elementAt(e)));
      if (!topology_.isDead(e)) add(elementAt(e), 1);
    }
    findIslands();
  }

  std::size_t pass() {
    std::size_t changes = 0;
    for (std::size_t e = 0; e < mesh().elements.size(); ++e)
      while (isWorthALook(e) && tryBest(e)) ++changes;
    return changes;
  }

 private:
  const Mesh& mesh() const { return topology_.mesh(); }
  const Element& elementAt(std::size_t e) const { return mesh().elements[e]; }
  VertexId endOf(Corner c) const { return topology_.vertexAt(topology_.next(c)); }

  void add(const Element& element, int sign) {
    for (const VertexId v : element.vertices()) {
      sum_[v.value] += sign * idealAngle(element);
      changed_[v.value] = clock_;
    }
  }

  /// Marks triangles of which only few hang together by their sides.
  void findIslands() {
    isOpen_.assign(mesh().elements.size(), 0);
    std::vector<std::uint8_t> isSeen(mesh().elements.size(), 0);
    std::vector<std::size_t> island;
    for (std::size_t e = 0; e < mesh().elements.size(); ++e) {
      if (topology_.isDead(e)) continue;
      isOpen_[e] = isOpen_[e] || elementAt(e).isQuad();
      if (isSeen[e] || elementAt(e).isQuad()) continue;
      island.assign(1, e);
      isSeen[e] = 1;
      for (std::size_t i = 0; i < island.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
          const Corner beyond = topology_.across(Corner(island[i], k));
          if (beyond.isNone() || isSeen[beyond.element()]) continue;
          if (elementAt(beyond.element()).isQuad()) continue;
          isSeen[beyond.element()] = 1;
          island.push_back(beyond.element());
        }
      if (island.size() > kLargestIsland) continue;
      for (const std::size_t triangle : island) isOpen_[triangle] = 1;
    }
  }

  bool isWorthALook(std::size_t e) const {
    if (topology_.isDead(e) || !isOpen_[e] || !hasChangedAt(e)) return false;
    if (!elementAt(e).isQuad()) return true;
    for (const VertexId v : elementAt(e).vertices())
      if (sum_[v.value] != wanted_[v.value]) return true;
    return distortion_[e] > kGoodDistortion;
  }

  /// Whether something was replaced at its vertices since it was looked at last.
  bool hasChangedAt(std::size_t e) const {
    return std::ranges::any_of(elementAt(e).vertices(),
                               [&](VertexId v) { return changed_[v.value] >= lookedAt_[e]; });
  }

  bool tryBest(std::size_t e) {
    lookedAt_[e] = ++clock_;
    best_ = {};
    gain_ = 1e-6;
    offerAround(e);
    if (best_.places.empty()) return false;
    for (const std::size_t place : best_.places) add(elementAt(place), -1);
    for (const Element& element : best_.elements) add(element, 1);
    const std::vector<std::size_t> places = topology_.replace(best_.places, best_.elements);
    isOpen_.resize(mesh().elements.size(), 1);
    lookedAt_.resize(mesh().elements.size(), 0);
    distortion_.resize(mesh().elements.size());
    for (const std::size_t place : places) distortion_[place] = distortion(elementAt(place));
    return true;
  }

  void offerAround(std::size_t e) {
    const auto n = static_cast<std::size_t>(elementAt(e).size());
    const bool isBad = distortion_[e] > kBadDistortion;
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
  }

  bool isInner(Corner c) const { return !topology_.isFixed(topology_.vertexAt(c)); }

  // ---- what could be done ----------------------------------------------------------------------

  /// The vertices of an element from one of its corners on.
  std::vector<VertexId> from(Corner c) const {
    std::vector<VertexId> vertices;
    for (int i = 0; i < topology_.sizeOf(c); ++i, c = topology_.next(c))
      vertices.push_back(topology_.vertexAt(c));
    return vertices;
  }

  /// Two elements side by side become one quadrilateral, or two others with the same outline.
  void offerResplits(Corner side) {
    const Corner other = topology_.across(side);
    std::vector<VertexId> ring = from(topology_.next(side));
    const std::vector<VertexId> beyond = from(topology_.next(other));
    ring.insert(ring.end(), beyond.begin() + 1, beyond.end() - 1);
    if (!areDifferent(ring)) return;
    const std::vector<std::size_t> places{side.element(), other.element()};
    if (ring.size() == 4) return offer({places, {elementOf(ring)}});
    offerHalves(places, ring);
  }

  /// A quadrilateral with triangles at two of its sides becomes two quadrilaterals.
  void offerTwoForThree(Corner one, Corner other) {
    const Corner apart[] = {topology_.across(one), topology_.across(other)};
    std::vector<VertexId> ring = from(Corner(one.element(), 0));
    for (const Corner& beyond : {apart[1], apart[0]}) {  // the later side first
      if (beyond.isNone() || topology_.sizeOf(beyond) != 3) return;
      const std::size_t i = topology_.across(beyond).index();
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                  topology_.vertexAt(topology_.previous(beyond)));
    }
    if (areDifferent(ring))
      offerHalves({one.element(), apart[0].element(), apart[1].element()}, ring);
  }

  /// A ring of five or six vertices is cut in two in each of the ways that leave no two triangles.
  void offerHalves(const std::vector<std::size_t>& places, std::vector<VertexId> ring) {
    const std::size_t across = ring.size() - 3;
    for (std::size_t i = 0; i < (ring.size() == 5 ? 5u : 3u); ++i) {
      std::rotate(ring.begin(), ring.begin() + 1, ring.end());
      if (topology_.areJoined(ring[0], ring[across])) continue;
      std::vector<VertexId> rest(ring.begin() + static_cast<std::ptrdiff_t>(across), ring.end());
      rest.push_back(ring[0]);
      offer({places, {elementOf(std::span(ring).first(across + 1)), elementOf(rest)}});
    }
  }

  /// A quadrilateral becomes two triangles.
  void offerSplit(Corner c) {
    const std::vector<VertexId> v = from(c);
    if (topology_.areJoined(v[0], v[2])) return;
    offer({{c.element()}, {{{v[0], v[1], v[2], {}}}, {{v[0], v[2], v[3], {}}}}});
  }

  /// A quadrilateral goes: one of its vertices moves into the opposite one.
  void offerDiagonalCollapse(Corner c) {
    for (const Corner beside : {topology_.next(c), topology_.previous(c)})
      if (topology_.valence(topology_.vertexAt(beside)) <= (isInner(beside) ? 3 : 1)) return;
    offerMerge(topology_.vertexAt(c), topology_.vertexAt(topology_.next(topology_.next(c))));
  }

  /// An inner vertex moves into another one of an element with both. Of the elements with both,
  /// triangles go, and quadrilaterals become triangles or, if the two are opposite, go as well.
  void offerMerge(VertexId gone, VertexId into) {
    Change change;
    std::vector<VertexId> shared, others;  // neighbours of `gone`, in elements with `into` and not
    const Corner first = topology_.cornerOf(gone);
    Corner c = first;
    do {
      if (c.isNone() || !isOpen_[c.element()]) return;
      change.places.push_back(c.element());
      std::vector<VertexId> ring = from(c);
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
    offer(std::move(change));
  }

  static bool areDifferent(std::span<const VertexId> vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (vertices[i] == vertices[k]) return false;
    return true;
  }

  static Element elementOf(std::span<const VertexId> ring) {
    Element element;
    std::ranges::copy(ring, element.corners.begin());
    return element;
  }

  // ---- what it would bring ---------------------------------------------------------------------

  double distortion(const Element& element) const {
    std::array<const SurfacePoint*, 4> corners{};
    const auto vertices = element.vertices();
    for (std::size_t i = 0; i < vertices.size(); ++i)
      corners[i] = &mesh().vertices[vertices[i].value];
    return elementDistortion({corners.data(), vertices.size()});
  }

  static double costOfShape(double distortion) {
    constexpr double kWorst = 20;
    const double excess = std::min(distortion, kWorst) - 1;
    return kDistortionCost * excess * excess;
  }
  static double costOfKind(const Element& element) { return element.isQuad() ? 0 : kTriangleCost; }

  /// Squared units of angle that a vertex has too many or too few; none if no element is left.
  double costOf(VertexId v, int sum) const {
    const int off = sum == 0 ? 0 : sum - wanted_[v.value];
    return off * off;
  }

  void offer(Change change) {
    double before = 0, after = 0, worst = kFairDistortion;
    angles_.clear();
    for (const std::size_t place : change.places) {
      const Element& element = elementAt(place);
      if (!isOpen_[place]) return;
      worst = std::max(worst, distortion_[place]);
      before += costOfKind(element) + costOfShape(distortion_[place]);
      for (const VertexId v : element.vertices()) angleAt(v) -= idealAngle(element);
    }
    for (const Element& element : change.elements) {
      after += costOfKind(element);
      for (const VertexId v : element.vertices()) angleAt(v) += idealAngle(element);
    }
    for (const auto& [v, more] : angles_) {
      before += costOf(v, sum_[v.value]);
      after += costOf(v, sum_[v.value] + more);
    }
    if (before - after <= gain_) return;  // whatever the shapes, which take longer to find out
    for (const Element& element : change.elements) {
      const double here = distortion(element);
      if (here > worst || !std::isfinite(here)) return;
      after += costOfShape(here);
    }
    if (before - after <= gain_) return;
    gain_ = before - after;
    best_ = std::move(change);
  }

  /// How much more angle a vertex would have, to be added up.
  int& angleAt(VertexId v) {
    for (auto& [vertex, more] : angles_)
      if (vertex == v) return more;
    return angles_.emplace_back(v, 0).second;
  }

  MeshTopology& topology_;
  std::vector<int> wanted_, sum_;     ///< by vertex: the angle there, and the ideal ones in all
  std::vector<std::uint8_t> isOpen_;  ///< by element: whether it may be replaced
  std::vector<double> distortion_;    ///< by element
  std::uint32_t clock_ = 0;           ///< counts looks
  std::vector<std::uint32_t> changed_, lookedAt_;  ///< by vertex, by element
  Change best_;
  double gain_ = 0;
  std::vector<std::pair<VertexId, int>> angles_;
};

}  // namespace

std::size_t tidyQuads(MeshTopology& topology, const std::vector<double>& anglesAtFixed) {
  constexpr int kMostPasses = 3;
  Tidier tidier(topology, anglesAtFixed);
  std::size_t changes = 0;
  for (int i = 0; i < kMostPasses; ++i) {
    const std::size_t more = tidier.pass();
    changes += more;
    if (more == 0) break;
  }
  return changes;
}

}  // namespace af2
