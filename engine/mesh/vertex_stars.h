// Element corners grouped by vertex: fast to build, with a fast test of whether the elements at a
// vertex surround it. Not installed.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engine/mesh/mesh.h"

namespace af2 {

class VertexStars {
 public:
  /// Number of vertices handled at once: stars for all vertices of a large mesh would take more
  /// memory than the mesh.
  static constexpr std::size_t kMaxAtOnce = 250'000;

  /// The vertices before and after a vertex in an element. The element's edges at the vertex lead
  /// to `next` and come from `previous`.
  struct Corner {
    std::uint32_t previous, next;
    bool operator==(const Corner&) const = default;
  };

  /// For the vertices from `begin` up to, but not including, `end`.
  VertexStars(std::size_t begin, std::size_t end)
      : begin_(begin),
        counts_(end - begin, 0),
        fans_(std::make_unique_for_overwrite<Fan[]>(end - begin)) {}

  /// Adds the corners of an element that are at these vertices. Vertex ids are below 2^32 - 2.
  void add(const Element& element) {
    const auto& [a, b, c, d] = element.corners;
    const VertexId last = d.isNone() ? c : d;
    add(a, last, b);
    add(b, a, c);
    add(c, b, d.isNone() ? a : d);
    if (!d.isNone()) add(d, c, a);
  }

  bool isEmpty(std::size_t vertex) const { return counts_[vertex - begin_] == 0; }

  /// Whether each edge at the vertex leaves it exactly once and arrives exactly once. This is true
  /// where the elements at a vertex inside a mesh surround it.
  bool areAround(std::size_t vertex) const {
    const std::uint32_t count = counts_[vertex - begin_];
    if (count == 0) return false;
    if (count > kSlots) return areAllAround(vertex);
    const Fan& fan = fans_[vertex - begin_];
    const auto previous = fours(fan.previous), next = fours(fan.next);
    // By slot, the number of corners that share its edge. The edges of empty slots match none.
    std::array<Four, 2> arriving{}, leaving{};
    for (std::size_t i = 0; i < count; ++i) {
      const Four to = all(fan.next[i]), from = all(fan.previous[i]);
      for (std::size_t half = 0; half < 2; ++half) {
        arriving[half] -= Four(previous[half] == to);
        leaving[half] -= Four(next[half] == from);
      }
    }
    Four wrong{};
    for (std::uint32_t half = 0; half < 2; ++half) {
      const Four isUsed = Four(Four{0, 1, 2, 3} + 4 * half < all(count));
      wrong |= ((arriving[half] ^ 1) | (leaving[half] ^ 1)) & isUsed;
    }
    return (wrong[0] | wrong[1] | wrong[2] | wrong[3]) == 0;
  }

  /// Must be called after all elements are added.
  void finish() { std::ranges::stable_sort(more_, {}, &std::pair<std::size_t, Corner>::first); }

  /// The corners of a vertex in the order in which they were added.
  void corners(std::size_t vertex, std::vector<Corner>& all) const {
    const std::size_t v = vertex - begin_, count = counts_[v];
    all.clear();
    for (std::size_t i = 0; i < std::min(count, kSlots); ++i)
      all.push_back({fans_[v].previous[i], fans_[v].next[i]});
    if (count > kSlots) {
      for (const auto& [at, corner] :
           std::ranges::equal_range(more_, vertex, {}, &std::pair<std::size_t, Corner>::first))
        all.push_back(corner);
    }
  }

 private:
  static constexpr std::size_t kSlots = 8;  // few vertices have more
  /// Corners of one vertex. They fill one cache line.
  struct alignas(64) Fan {
    std::array<std::uint32_t, kSlots> previous, next;
  };
  static constexpr std::uint32_t kNoPrevious = 0xffffffffu, kNoNext = 0xfffffffeu;
  static constexpr Fan kEmpty = [] {
    Fan fan{};
    fan.previous.fill(kNoPrevious);
    fan.next.fill(kNoNext);
    return fan;
  }();

  using Four = std::uint32_t __attribute__((vector_size(16)));
  static Four all(std::uint32_t value) { return Four{value, value, value, value}; }
  static std::array<Four, 2> fours(const std::array<std::uint32_t, kSlots>& slots) {
    return std::bit_cast<std::array<Four, 2>>(slots);
  }

  void add(VertexId vertex, VertexId previous, VertexId next) {
    const std::size_t v = vertex.value - begin_;
    if (v >= counts_.size()) return;
    const std::uint32_t count = counts_[v];
    if (count >= kSlots) return addMore(vertex.value, {previous.value, next.value});
    Fan& fan = fans_[v];
    if (count == 0) fan = kEmpty;
    fan.previous[count] = previous.value;
    fan.next[count] = next.value;
    counts_[v] = static_cast<std::uint16_t>(count + 1);
  }

  [[gnu::noinline]] void addMore(std::size_t vertex, Corner corner) {
    counts_[vertex - begin_] = kSlots + 1;
    more_.emplace_back(vertex, corner);
  }

  bool areAllAround(std::size_t vertex) const {
    std::vector<Corner> all;
    corners(vertex, all);
    std::vector<std::uint32_t> arriving, leaving;
    for (const Corner& corner : all) {
      arriving.push_back(corner.previous);
      leaving.push_back(corner.next);
    }
    std::ranges::sort(arriving);
    std::ranges::sort(leaving);
    return arriving == leaving && std::ranges::adjacent_find(arriving) == arriving.end();
  }

  std::size_t begin_;
  std::vector<std::uint16_t> counts_;  ///< kSlots + 1: the rest is in more_
  std::unique_ptr<Fan[]> fans_;        ///< entries of vertices without corners are not initialized
  std::vector<std::pair<std::size_t, Corner>> more_;
};

}  // namespace af2
