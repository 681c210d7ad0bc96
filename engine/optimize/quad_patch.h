// A small part of a mesh of quadrilaterals, on which other ways to join its vertices are tried.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace af2 {

/// What the patch knows of a vertex of the mesh. Angles are in units of 30 degrees.
struct PatchVertex {
  std::int8_t wanted = 12;  ///< the angle there
  std::int8_t sum = 0;      ///< the sum of its elements' ideal angles: 3 for each quadrilateral
  bool isFixed = false;     ///< on the boundary of the region
  bool isInner = false;     ///< not fixed, and all its elements belong to the patch
};

/// Elements of a patch, each with three or four vertices, counter-clockwise. Copied often: it
/// allocates nothing.
class QuadPatch {
 public:
  using Vertex = std::uint8_t;
  using Ring = std::array<Vertex, 4>;
  static constexpr Vertex kNone = 0xff;
  static constexpr std::size_t kMaxElements = 240, kMaxVertices = 254;

  /// One element at a vertex: the vertex is followed by `next`, `opposite` and `previous`.
  struct Spoke {
    std::uint8_t element;
    Vertex next, opposite, previous;
  };
  /// The elements at a vertex, counter-clockwise.
  struct Star {
    static constexpr std::size_t kMax = 16;
    std::array<Spoke, kMax> spokes;
    std::size_t size = 0;
    bool isClosed = false;  ///< the last element is followed by the first
    /// Whether all elements are quadrilaterals, in one sector, and not too many.
    bool isUsable = false;
  };

  /// A way to join the vertices differently. Source of the three kinds: [Kinney97].
  struct Act {
    enum class Kind : std::uint8_t {
      Collapse,  ///< `vertex` moves to `other`, the opposite corner of `element`, which vanishes
      Rotate,    ///< the side shared by `element` and `beyond` moves on by one vertex
      Open,      ///< `vertex` becomes two, with a new element between them from `from` to `to`
    };
    Kind kind{};
    Vertex vertex = kNone, other = kNone;
    std::uint8_t element = 0, beyond = 0;  ///< Rotate only: with the new rings below
    Ring ring{}, ringBeyond{};
    std::uint8_t from = 0, to = 0;  ///< Open only: indices in the star of `vertex`
  };

  Vertex add(const PatchVertex& vertex);
  void add(const Ring& ring);
  /// Must be called after the last `add`.
  void finish();

  std::size_t vertexCount() const { return vertexCount_; }
  std::size_t elementCount() const { return elementCount_; }
  const Ring& ringAt(std::size_t element) const { return rings_[element]; }
  /// The vertices of an element: three or four.
  std::span<const Vertex> cornersAt(std::size_t element) const {
    const Ring& ring = rings_[element];
    return {ring.data(), ring[3] == kNone ? 3u : 4u};
  }
  bool isAlive(std::size_t element) const { return rings_[element][0] != kNone; }
  bool isInner(Vertex v) const { return isInner_[v]; }
  bool isFixed(Vertex v) const { return isFixed_[v]; }
  /// Whether the boundary is sharp at a vertex: below 45 degrees.
  bool isTip(Vertex v) const { return isFixed_[v] && wanted_[v] <= 1; }
  /// The vertex that a new vertex was split from; the vertex itself if it is not new.
  Vertex originOf(Vertex v) const { return origin_[v]; }

  /// How far the sums of angles are from what the vertices want; a regular vertex adds nothing.
  int energy() const { return energy_; }
  int energyAt(Vertex v) const { return energyOf(v, sum_[v]); }
  /// Whether an act has changed the elements at the vertex.
  bool isTouched(Vertex v) const { return isTouched_[v]; }

  Star starOf(Vertex v) const;
  bool areJoined(Vertex u, Vertex v) const;

  /// The energy after an act.
  int energyAfter(const Act& act) const;
  /// Whether the act leaves elements without repeated vertices and sides.
  bool allows(const Act& act) const;
  void apply(const Act& act);
  /// Gives two elements other vertices, among those that they have together; an empty ring removes
  /// the second one. Returns false, and does nothing, if vertices or sides would be repeated.
  bool replace(std::size_t one, const Ring& ring, std::size_t other, const Ring& ringBeyond);
  /// Adds an inner vertex that no element uses yet; none if there is no room for it.
  std::optional<Vertex> addInner(Vertex origin);
  /// Replaces elements by quadrilaterals with the same outline. Returns false, and leaves the patch
  /// unusable, if sides would be repeated, there are too many elements, or one is to go twice.
  bool refill(std::span<const std::size_t> gone, std::span<const Ring> rings);

 private:
  int energyOf(Vertex v, int sum) const;
  /// The change of energy if the sum at a vertex grows by `more`.
  int growth(Vertex v, int more) const { return energyOf(v, sum_[v] + more) - energyAt(v); }
  void addToSum(Vertex v, int more);
  void addAngles(std::size_t element, int sign);
  bool repeatsSides() const;

  std::array<Ring, kMaxElements> rings_;
  std::array<std::int8_t, kMaxVertices> sum_{}, wanted_{};
  std::array<bool, kMaxVertices> isInner_{}, isFixed_{}, isTouched_{};
  std::array<Vertex, kMaxVertices> origin_{};
  std::size_t elementCount_ = 0, vertexCount_ = 0;
  int energy_ = 0;
};

/// Calls visit(const QuadPatch::Act&) for every act at the elements of a vertex.
template <class Visit>
void forEachAct(const QuadPatch& patch, QuadPatch::Vertex v, Visit&& visit) {
  using Act = QuadPatch::Act;
  const QuadPatch::Star star = patch.starOf(v);
  if (!star.isUsable) return;
  const std::size_t n = star.size;
  const auto collapse = [&](std::uint8_t element, QuadPatch::Vertex gone, QuadPatch::Vertex into) {
    if (!patch.isInner(gone)) return;
    Act act;
    act.kind = Act::Kind::Collapse;
    act.vertex = gone;
    act.other = into;
    act.element = element;
    visit(act);
  };
  for (std::size_t k = 0; k < n; ++k) {
    const QuadPatch::Spoke& s = star.spokes[k];
    collapse(s.element, v, s.opposite);
    collapse(s.element, s.opposite, v);
    collapse(s.element, s.next, s.previous);
    collapse(s.element, s.previous, s.next);
    if (k == 0 && !star.isClosed) continue;
    const QuadPatch::Spoke& before = star.spokes[k == 0 ? n - 1 : k - 1];
    if (n < 2 || (patch.isFixed(v) && patch.isFixed(s.next))) continue;
    Act act;
    act.kind = Act::Kind::Rotate;
    act.vertex = v;
    act.other = s.next;
    act.element = before.element;
    act.beyond = s.element;
    act.ring = {before.next, before.opposite, s.next, s.opposite};
    act.ringBeyond = {s.opposite, s.previous, v, before.next};
    visit(act);
    act.ring = {before.opposite, s.next, s.opposite, s.previous};
    act.ringBeyond = {s.previous, v, before.next, before.opposite};
    visit(act);
  }
  if (patch.isFixed(v) ? star.isClosed : !patch.isInner(v)) return;
  for (std::size_t i = star.isClosed ? 0 : 1; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      if (patch.isFixed(v) &&
          (patch.isFixed(star.spokes[i].next) || patch.isFixed(star.spokes[j].next)))
        continue;
      Act act;
      act.kind = Act::Kind::Open;
      act.vertex = v;
      act.from = static_cast<std::uint8_t>(i);
      act.to = static_cast<std::uint8_t>(j);
      visit(act);
    }
}

}  // namespace af2
