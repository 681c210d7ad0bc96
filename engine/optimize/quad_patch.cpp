#include "engine/optimize/quad_patch.h"

#include <algorithm>
#include <vector>

#include "engine/base/error.h"
#include "engine/optimize/ideal_angles.h"

namespace af2 {
namespace {

/// The distance, in units, from the nearest sum that right angles can have at the vertex: no act
/// can do better.
int leastOff(int wanted) {
  const int remainder = wanted % kRightAngle;
  return wanted < kRightAngle ? kRightAngle - wanted : std::min(remainder, kRightAngle - remainder);
}

}  // namespace

QuadPatch::Vertex QuadPatch::add(const PatchVertex& vertex) {
  AF2_CHECK(vertexCount_ < kMaxVertices, "a patch has room for its vertices");
  const auto v = static_cast<Vertex>(vertexCount_++);
  wanted_[v] = vertex.wanted;
  sum_[v] = vertex.sum;
  isFixed_[v] = vertex.isFixed;
  isInner_[v] = vertex.isInner;
  origin_[v] = v;
  return v;
}

void QuadPatch::add(const Ring& ring) {
  AF2_CHECK(elementCount_ < kMaxElements, "a patch has room for its elements");
  rings_[elementCount_++] = ring;
}

void QuadPatch::finish() {
  energy_ = 0;
  for (std::size_t v = 0; v < vertexCount_; ++v) energy_ += energyAt(static_cast<Vertex>(v));
}

/// Inner vertices with two elements make both of them flat; with one, the mesh is no mesh.
int QuadPatch::energyOf(Vertex v, int sum) const {
  constexpr int kFar = 18, kDoublet = 540, kImpossible = 9000;
  if (sum == 0) return isFixed_[v] ? kImpossible : 0;  // an inner vertex is gone
  const int off = sum - wanted_[v], square = off * off;
  if (isFixed_[v]) {
    const int least = leastOff(wanted_[v]);
    return 2 * (square - least * least);
  }
  if (sum <= kRightAngle) return kImpossible;
  if (sum <= 2 * kRightAngle) return kDoublet;
  return square + (std::abs(off) > kRightAngle ? kFar : 0);
}

void QuadPatch::addToSum(Vertex v, int more) {
  energy_ += growth(v, more);
  sum_[v] = static_cast<std::int8_t>(sum_[v] + more);
  isTouched_[v] = true;
}

QuadPatch::Star QuadPatch::starOf(Vertex v) const {
  Star star;
  bool isSound = true;
  for (std::size_t e = 0; e < elementCount_; ++e) {
    const Ring& ring = rings_[e];
    if (ring[0] == kNone) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      if (ring[i] != v) continue;
      if (star.size == Star::kMax || ring[3] == kNone) {
        isSound = false;
        break;
      }
      star.spokes[star.size++] = {static_cast<std::uint8_t>(e), ring[(i + 1) % 4],
                                  ring[(i + 2) % 4], ring[(i + 3) % 4]};
    }
  }
  if (!isSound || star.size == 0) return star;
  const auto begin = star.spokes.begin(), end = begin + static_cast<std::ptrdiff_t>(star.size);
  // Where the star is open, its first element follows none.
  const auto first = std::find_if(begin, end, [&](const Spoke& s) {
    return std::none_of(begin, end, [&](const Spoke& o) { return o.previous == s.next; });
  });
  star.isClosed = first == end;
  if (!star.isClosed) std::iter_swap(begin, first);
  for (auto spoke = begin; spoke + 1 != end; ++spoke) {
    const auto following =
        std::find_if(spoke + 1, end, [&](const Spoke& s) { return s.next == spoke->previous; });
    if (following == end) return star;  // several sectors
    std::iter_swap(spoke + 1, following);
  }
  star.isUsable = !star.isClosed || (end - 1)->previous == begin->next;
  return star;
}

bool QuadPatch::areJoined(Vertex u, Vertex v) const {
  for (std::size_t e = 0; e < elementCount_; ++e) {
    if (!isAlive(e)) continue;
    const std::span<const Vertex> ring = cornersAt(e);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vertex w = ring[i + 1 == ring.size() ? 0 : i + 1];
      if ((ring[i] == u && w == v) || (ring[i] == v && w == u)) return true;
    }
  }
  return false;
}

int QuadPatch::energyAfter(const Act& act) const {
  switch (act.kind) {
    case Act::Kind::Collapse: {
      const Ring& ring = rings_[act.element];
      const int moved = sum_[act.vertex] - 2 * kRightAngle;
      int energy = energy_ - energyAt(act.vertex) + growth(act.other, moved);
      for (const Vertex v : ring)
        if (v != act.vertex && v != act.other) energy += growth(v, -kRightAngle);
      return energy;
    }
    case Act::Kind::Rotate: {
      int energy = energy_ + growth(act.vertex, -kRightAngle) + growth(act.other, -kRightAngle);
      for (const Vertex v : act.ring)
        if (std::ranges::find(act.ringBeyond, v) != act.ringBeyond.end())
          energy += growth(v, kRightAngle);
      return energy;
    }
    case Act::Kind::Open: {
      const Star star = starOf(act.vertex);
      const int moved = kRightAngle * (act.to - act.from);
      const int sum = moved + kRightAngle;  // of the new vertex
      const int off = sum - kFullTurn;
      constexpr int kLarge = 9000;
      int energy = energy_ + growth(act.vertex, kRightAngle - moved) +
                   growth(star.spokes[act.from].next, kRightAngle) +
                   growth(star.spokes[act.to].next, kRightAngle);
      energy += sum <= 2 * kRightAngle ? kLarge : off * off;
      return energy;
    }
  }
  return energy_;
}

bool QuadPatch::allows(const Act& act) const {
  switch (act.kind) {
    case Act::Kind::Collapse: {
      const Star star = starOf(act.vertex);
      if (!star.isUsable || !star.isClosed) return false;
      for (const Spoke& s : std::span(star.spokes).first(star.size)) {
        if (s.element == act.element) continue;
        if (s.opposite == act.other || s.next == act.other || s.previous == act.other) return false;
        // A side that the vertex brings along must not exist already.
        const Ring& ring = rings_[act.element];
        if (std::ranges::find(ring, s.next) == ring.end() && areJoined(act.other, s.next))
          return false;
      }
      return true;
    }
    case Act::Kind::Rotate: {
      std::array<Vertex, 2> ends{kNone, kNone};
      std::size_t found = 0;
      for (const Vertex v : act.ring)
        if (found < 2 && std::ranges::find(act.ringBeyond, v) != act.ringBeyond.end())
          ends[found++] = v;
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < i; ++k)
          if (act.ring[i] == act.ring[k] || act.ringBeyond[i] == act.ringBeyond[k]) return false;
      return found == 2 && !areJoined(ends[0], ends[1]);
    }
    case Act::Kind::Open:
      return vertexCount_ < kMaxVertices && elementCount_ < kMaxElements;
  }
  return false;
}

void QuadPatch::apply(const Act& act) {
  switch (act.kind) {
    case Act::Kind::Collapse: {
      const int moved = sum_[act.vertex] - 2 * kRightAngle;
      for (const Vertex v : rings_[act.element])
        if (v != act.vertex && v != act.other) addToSum(v, -kRightAngle);
      rings_[act.element][0] = kNone;
      for (Ring& ring : std::span(rings_).first(elementCount_))
        if (ring[0] != kNone) std::ranges::replace(ring, act.vertex, act.other);
      addToSum(act.vertex, -sum_[act.vertex]);
      addToSum(act.other, moved);
      return;
    }
    case Act::Kind::Rotate: {
      addToSum(act.vertex, -kRightAngle);
      addToSum(act.other, -kRightAngle);
      for (const Vertex v : act.ring)
        if (std::ranges::find(act.ringBeyond, v) != act.ringBeyond.end()) addToSum(v, kRightAngle);
      rings_[act.element] = act.ring;
      rings_[act.beyond] = act.ringBeyond;
      return;
    }
    case Act::Kind::Open: {
      const Star star = starOf(act.vertex);
      const Vertex split = addInner(act.vertex).value();
      const Vertex from = star.spokes[act.from].next, to = star.spokes[act.to].next;
      for (std::size_t k = act.from; k < act.to; ++k)
        std::ranges::replace(rings_[star.spokes[k].element], act.vertex, split);
      add(Ring{from, split, to, act.vertex});
      const int moved = kRightAngle * (act.to - act.from);
      addToSum(split, moved + kRightAngle);
      addToSum(act.vertex, kRightAngle - moved);
      addToSum(from, kRightAngle);
      addToSum(to, kRightAngle);
      return;
    }
  }
}

void QuadPatch::addAngles(std::size_t element, int sign) {
  const std::span<const Vertex> corners = cornersAt(element);
  for (const Vertex v : corners) addToSum(v, sign * (corners.size() == 3 ? 2 : kRightAngle));
}

bool QuadPatch::replace(std::size_t one, const Ring& ring, std::size_t other,
                        const Ring& ringBeyond) {
  const auto sideOf = [](const Ring& r, std::size_t i) {
    const std::size_t n = r[3] == kNone ? 3 : 4;
    return std::pair(r[i % n], r[(i + 1) % n]);
  };
  for (const Ring* r : {&ring, &ringBeyond})
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < i; ++k)
        if ((*r)[i] == (*r)[k] && (*r)[i] != kNone) return false;
  // Only the side between the two new elements is new.
  for (std::size_t i = 0; i < 4 && ringBeyond[0] != kNone; ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [from, to] = sideOf(ring, i);
      if (sideOf(ringBeyond, k) == std::pair(to, from) && areJoined(from, to)) return false;
    }
  for (const std::size_t e : {one, other}) addAngles(e, -1);
  rings_[one] = ring;
  rings_[other] = ringBeyond;
  for (const std::size_t e : {one, other})
    if (isAlive(e)) addAngles(e, 1);
  return true;
}

std::optional<QuadPatch::Vertex> QuadPatch::addInner(Vertex origin) {
  if (vertexCount_ == kMaxVertices) return std::nullopt;
  PatchVertex vertex;
  vertex.isInner = true;
  const Vertex added = add(vertex);
  origin_[added] = origin_[origin];
  return added;
}

bool QuadPatch::refill(std::span<const std::size_t> gone, std::span<const Ring> rings) {
  if (elementCount_ + rings.size() > kMaxElements + gone.size()) return false;
  for (const std::size_t e : gone) {
    if (!isAlive(e)) return false;  // it was among them before
    addAngles(e, -1);
    rings_[e] = {kNone, kNone, kNone, kNone};
  }
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const std::size_t e = i < gone.size() ? gone[i] : elementCount_++;
    rings_[e] = rings[i];
    addAngles(e, 1);
  }
  return !repeatsSides();
}

bool QuadPatch::repeatsSides() const {
  std::vector<std::pair<Vertex, Vertex>> sides;
  for (std::size_t e = 0; e < elementCount_; ++e) {
    if (!isAlive(e)) continue;
    const std::span<const Vertex> corners = cornersAt(e);
    for (std::size_t i = 0; i < corners.size(); ++i)
      sides.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
  }
  std::ranges::sort(sides);
  return std::ranges::adjacent_find(sides) != sides.end();
}

}  // namespace af2
