// The sides of all elements of a mesh, grouped by their lower vertex in linear time.
// Not installed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <ranges>
#include <span>
#include <vector>

#include "geometry/mesh/model_mesh.h"
#include "geometry/mesh/vertex_blocks.h"

namespace af2::geometry {

/// One side of an element, filed under its lower vertex.
struct MeshSide {
  std::uint32_t to;   ///< the higher vertex
  std::uint32_t use;  ///< of elements; there are fewer than 2^31

  MeshSide(std::uint32_t higher, std::size_t element, bool isForward)
      : to(higher), use(static_cast<std::uint32_t>(2 * element + isForward)) {}
  MeshSide() : MeshSide(0, 0, false) {}
  std::size_t element() const { return use / 2; }
  bool isForward() const { return use % 2 != 0; }  ///< from the lower vertex to the higher
};

class MeshSides {
 public:
  explicit MeshSides(const ModelMesh& mesh)
      : MeshSides({0, mesh.vertices.size()}, mesh.elements,
                  std::views::iota(std::size_t{0}, mesh.elements.size()),
                  [](std::uint32_t, std::uint32_t) { return true; }) {}

  /// The sides of some vertices.
  ///
  /// of        all elements
  /// elements  whose sides are stored, ascending; only their corners have to be vertices
  /// isThere   whether to store the sides from a vertex to a higher one
  template <class Elements, class IsThere>
  MeshSides(VertexRange vertices, std::span<const Element> of, const Elements& elements,
            const IsThere& isThere)
      : begin_(vertices.begin), first_(vertices.end - vertices.begin + 2, 0) {
    const auto isStored = [&](std::uint32_t from, const MeshSide& side) {
      return vertices.contains(from) && isThere(from, side.to);
    };
    forEachSide(of, elements, [&](std::uint32_t from, const MeshSide& side) {
      if (isStored(from, side)) ++first_[from - begin_ + 2];
    });
    for (std::size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
    sides_.resize(first_.back());
    // first_[v + 1] is the index of the next side of v; when all are placed, it is the end of v's
    // sides.
    forEachSide(of, elements, [&](std::uint32_t from, const MeshSide& side) {
      if (isStored(from, side)) sides_[first_[from - begin_ + 1]++] = side;
    });
    for (std::size_t v = 0; v + 2 < first_.size(); ++v) sort(first_[v], first_[v + 1]);
  }

  /// The sides of a vertex, by their higher vertex and in the order of the elements.
  std::span<const MeshSide> of(std::size_t vertex) const {
    const std::size_t v = vertex - begin_;
    return {sides_.data() + first_[v], first_[v + 1] - first_[v]};
  }
  std::size_t count() const { return sides_.size(); }

  /// Calls visit(from, sides) for each edge of the mesh, by its lower vertex `from` and then by its
  /// higher one; `sides` are those of the elements that have it, at least one.
  template <class Visit>
  void forEachEdge(const Visit& visit) const {
    for (std::size_t v = begin_; v + 2 < begin_ + first_.size(); ++v) {
      std::span<const MeshSide> left = of(v);
      while (!left.empty()) {
        std::size_t count = 1;
        while (count < left.size() && left[count].to == left.front().to) ++count;
        visit(VertexId(v), left.first(count));
        left = left.subspan(count);
      }
    }
  }

 private:
  template <class Elements, class Visit>
  static void forEachSide(std::span<const Element> of, const Elements& elements,
                          const Visit& visit) {
    for (const std::size_t i : elements) {
      const auto corners = of[i].vertices();
      std::uint32_t last = corners.back().value;
      for (const VertexId corner : corners) {
        const std::uint32_t next = corner.value;
        visit(std::min(last, next), MeshSide(std::max(last, next), i, last < next));
        last = next;
      }
    }
  }

  /// Insertion sort, because almost all groups have only a few sides.
  void sort(std::size_t begin, std::size_t end) {
    constexpr std::size_t kFew = 24;
    const auto isLess = [](const MeshSide& a, const MeshSide& b) { return a.to < b.to; };
    if (end - begin > kFew) {
      std::stable_sort(sides_.begin() + static_cast<std::ptrdiff_t>(begin),
                       sides_.begin() + static_cast<std::ptrdiff_t>(end), isLess);
      return;
    }
    for (std::size_t i = begin + 1; i < end; ++i) {
      const MeshSide side = sides_[i];
      std::size_t k = i;
      for (; k > begin && isLess(side, sides_[k - 1]); --k) sides_[k] = sides_[k - 1];
      sides_[k] = side;
    }
  }

  std::size_t begin_;  ///< the first vertex
  std::vector<std::uint32_t> first_;
  std::vector<MeshSide> sides_;
};

}  // namespace af2::geometry
