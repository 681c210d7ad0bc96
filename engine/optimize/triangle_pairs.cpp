#include "engine/optimize/triangle_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace af2 {
namespace {

/// Largest distance of two triangles, in elements; number of partners tried for each triangle;
/// number of partial ways followed at a time to each partner.
constexpr int kReach = 14;
constexpr std::size_t kMaxPartners = 4, kMaxWays = 12;
/// Elements along the way become slanted, and smoothing straightens them.
constexpr Leniency kLeaning{4, 0.25};

/// A triangle on its way: its changes so far, and the side by which it continues.
struct Way {
  Change change;
  double distortion = 0;  ///< cost of the new elements minus cost of the old ones
  double gain = 0;        ///< if the triangle stayed here
  Corner out;
  VertexId third;  ///< the triangle's vertex that is not on that side
};

class Pairing {
 public:
  explicit Pairing(QuadChanges& changes) : changes_(changes), topology_(changes.topology()) {}

  bool pair(std::size_t triangle) {
    const std::vector<std::size_t> partners = explore(triangle);
    bool isPaired = false;
    for (std::size_t i = 0; i < partners.size() && !isPaired; ++i) {
      walk(partners[i]);
      isPaired = changes_.apply(FinishAct::Kind::Pairing);
    }
    for (const std::size_t e : explored_) distance_[e] = -1;
    return isPaired;
  }

 private:
  /// Computes each element's distance from a triangle. Returns the nearest other triangles.
  std::vector<std::size_t> explore(std::size_t triangle) {
    std::vector<std::size_t> found;
    distance_.resize(changes_.elementCount(), -1);
    explored_.assign(1, triangle);
    distance_[triangle] = 0;
    for (std::size_t i = 0; i < explored_.size() && found.size() < kMaxPartners; ++i) {
      const std::size_t e = explored_[i];
      const bool isQuad = changes_.elementAt(e).isQuad();
      if (!isQuad && e != triangle) found.push_back(e);
      if ((!isQuad && e != triangle) || distance_[e] == kReach) continue;
      for (std::size_t k = 0; k < (isQuad ? 4u : 3u); ++k) {
        const Corner beyond = topology_.across(Corner(e, k));
        if (beyond.isNone() || !changes_.isOpen(beyond.element())) continue;
        int& distance = distance_[beyond.element()];
        if (distance >= 0) continue;
        distance = distance_[e] + 1;
        explored_.push_back(beyond.element());
      }
    }
    return found;
  }

  /// Whether the element beyond the side is one step nearer to the triangle that was explored from.
  bool leadsOn(Corner side) const {
    const Corner beyond = topology_.across(side);
    return !beyond.isNone() && distance_[beyond.element()] == distance_[side.element()] - 1;
  }

  void walk(std::size_t triangle) {
    std::vector<Way> ways;
    Way start;
    start.change.places = {triangle};
    for (std::size_t k = 0; k < 3; ++k) {
      start.out = Corner(triangle, k);
      start.third = topology_.vertexAt(topology_.previous(start.out));
      if (leadsOn(start.out)) ways.push_back(start);
    }
    while (!ways.empty()) {
      std::vector<Way> longer;
      for (const Way& way : ways) goOn(way, longer);
      std::ranges::stable_sort(longer, std::greater<>(), &Way::gain);
      if (longer.size() > kMaxWays) longer.resize(kMaxWays);
      ways = std::move(longer);
    }
  }

  /// Divides the triangle and the element beyond its side in other ways.
  void goOn(const Way& way, std::vector<Way>& longer) {
    const Corner in = topology_.across(way.out);
    const std::vector<VertexId> beyond = changes_.from(in);
    const VertexId to = beyond[0], from = beyond[1];
    Way next = way;
    next.change.places.push_back(in.element());
    if (beyond.size() == 3) {
      next.change.elements.push_back({{way.third, from, beyond[2], to}});
      if (areDifferent(next.change.elements.back().vertices()))
        changes_.offer(std::move(next.change), kLeaning);
      return;
    }
    const VertexId m = beyond[2], n = beyond[3];
    const Corner ahead = topology_.next(topology_.next(in));  // m to n
    leave(next, {{way.third, from, n, to}}, {{from, m, n, {}}}, {topology_.next(in), ahead},
          longer);
    leave(next, {{way.third, from, m, to}}, {{m, n, to, {}}}, {ahead, topology_.previous(in)},
          longer);
  }

  /// Leaves the element `made` behind. The triangle `rest` continues by one of the two sides
  /// `outs`, which must be its first two.
  void leave(Way way, const Element& made, const Element& rest, std::array<Corner, 2> outs,
             std::vector<Way>& longer) {
    const std::size_t place = way.change.places.back();
    const double here = areDifferent(made.vertices()) ? changes_.distortionOf(made) : INFINITY;
    if (!(here <= kLeaning.worst) || !std::isfinite(changes_.distortionOf(rest))) return;
    if (topology_.areJoined(rest.corners[0], rest.corners[2])) return;
    way.distortion +=
        changes_.costOfDistortion(here) - changes_.costOfDistortion(changes_.distortionAt(place));
    way.change.elements.push_back(rest);
    way.gain = changes_.gainOf(way.change) - kLeaning.shapeWeight * way.distortion;
    way.change.elements.back() = made;
    for (std::size_t i = 0; i < 2; ++i) {
      if (!leadsOn(outs[i])) continue;
      way.out = outs[i];
      way.third = rest.corners[i == 0 ? 2 : 0];
      longer.push_back(way);
    }
  }

  QuadChanges& changes_;
  const MeshTopology& topology_;
  std::vector<int> distance_;  ///< by element; -1: not explored
  std::vector<std::size_t> explored_;
};

}  // namespace

std::size_t pairTriangles(QuadChanges& changes, const WorkWatch& watch) {
  Pairing pairing(changes);
  std::size_t pairs = 0;
  for (std::size_t e = 0; e < changes.elementCount(); ++e) {
    if (changes.topology().isDead(e) || !changes.isOpen(e) || changes.elementAt(e).isQuad())
      continue;
    if (watch.mustStop()) break;
    if (pairing.pair(e)) ++pairs;
  }
  return pairs;
}

}  // namespace af2
