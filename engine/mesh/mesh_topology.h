// Adjacency of elements for the optimiser: a corner table that swaps and collapses update.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/mesh/front_input.h"
#include "engine/mesh/mesh.h"

namespace af2 {

/// One corner of one element. Also identifies the side from there to the next corner.
struct Corner {
  std::int32_t code = -1;  ///< 4 * element + index; -1: none

  Corner() = default;
  Corner(std::size_t element, std::size_t index)
      : code(static_cast<std::int32_t>(4 * element + index)) {}
  bool isNone() const { return code < 0; }
  std::size_t element() const { return static_cast<std::size_t>(code) / 4; }
  std::size_t index() const { return static_cast<std::size_t>(code) % 4; }
  bool operator==(const Corner&) const = default;
};

/// Adjacency of a mesh. The boundary edges that the mesh was made from are its rim, on both of
/// their sides: no swap and no walk crosses them.
class MeshTopology {
 public:
  MeshTopology(Mesh& mesh, const MeshBoundary& boundary);

  const Mesh& mesh() const { return mesh_; }
  VertexId vertexAt(Corner c) const { return mesh_.elements[c.element()].corners[c.index()]; }
  Corner next(Corner c) const {
    const std::size_t i = c.index() + 1;
    return {c.element(), i == static_cast<std::size_t>(sizeOf(c)) ? 0 : i};
  }
  Corner previous(Corner c) const {
    const std::size_t i = c.index();
    return {c.element(), (i == 0 ? static_cast<std::size_t>(sizeOf(c)) : i) - 1};
  }
  int sizeOf(Corner c) const { return mesh_.elements[c.element()].size(); }
  /// The same side in the other element, where it has the opposite direction; none on the rim.
  Corner across(Corner c) const { return across_[static_cast<std::size_t>(c.code)]; }
  /// The corner of the same vertex in the next element counter-clockwise; none on the rim.
  Corner aroundVertex(Corner c) const { return across(previous(c)); }
  /// A corner of the vertex, on the rim the first counter-clockwise; none if no element uses it.
  Corner cornerOf(VertexId v) const { return cornerOf_[v.value]; }

  /// Visits the corners of a vertex counter-clockwise.
  void forEachCornerOf(VertexId v, auto&& visit) const {
    const Corner first = cornerOf(v);
    for (Corner c = first; !c.isNone();) {
      visit(c);
      c = aroundVertex(c);
      if (c == first) break;
    }
  }

  /// Calls visit(VertexId) for the other end of each side at the vertex.
  void forEachNeighborOf(VertexId v, auto&& visit) const {
    Corner last;
    forEachCornerOf(v, [&](Corner c) {
      visit(vertexAt(next(c)));
      last = c;
    });
    if (!last.isNone() && aroundVertex(last).isNone()) visit(vertexAt(previous(last)));
  }

  /// Number of elements at a vertex, at most 255.
  int valence(VertexId v) const { return valence_[v.value]; }
  bool isFixed(VertexId v) const { return v.value < fixedCount_; }
  std::size_t fixedCount() const { return fixedCount_; }
  bool isDead(std::size_t element) const { return mesh_.elements[element].corners[0].isNone(); }

  /// The angle that the mesh has at each fixed vertex, in radians.
  std::vector<double> anglesAtFixed() const;

  /// Whether an element side joins the two vertices.
  bool areJoined(VertexId u, VertexId v) const;

  /// Swaps the side shared by two triangles: (a, b, c), (b, a, d) become (a, d, c), (d, b, c).
  void swap(Corner side);
  /// Moves the inner vertex at the start of a side to the vertex at its end. The elements on both
  /// sides of it, which must be triangles, vanish.
  void collapse(Corner side);
  /// Replaces elements by others that cover the same part of the surface; additional ones are
  /// appended. Unused old elements are dead, as are vertices that no element uses any more. Returns
  /// the indices of the new elements.
  std::vector<std::size_t> replace(std::vector<std::size_t> places,
                                   std::span<const Element> elements);
  /// Adds an inner vertex, which no element uses yet.
  VertexId addVertex(const SurfacePoint& point);
  /// Moves an inner vertex.
  void move(VertexId v, const SurfacePoint& point);
  /// The vertices of all elements that changed since the last call, unordered and with repetitions.
  std::vector<VertexId> takeChanged() { return std::exchange(changed_, {}); }
  /// What was found out about an element (by whoever gives such grades) since it or one of its
  /// vertices last changed; 0: nothing.
  std::uint8_t gradeOf(std::size_t element) const { return grades_[element]; }
  void setGrade(std::size_t element, std::uint8_t grade) { grades_[element] = grade; }
  /// For those who move vertices themselves.
  void dropGrade(std::size_t element) { grades_[element] = 0; }

  /// Removes what collapses left dead. The topology must not be used afterwards.
  void compact();

 private:
  void setAcross(Corner c, Corner d);
  void pairSides();
  void findCorners(const MeshBoundary& boundary);
  void renewCornerOf(Corner c);
  void noteChange(std::size_t element) {
    mesh_.origins[element].isChanged = true;
    dropGrade(element);
    const auto vertices = mesh_.elements[element].vertices();
    changed_.insert(changed_.end(), vertices.begin(), vertices.end());
  }

  Mesh& mesh_;
  std::size_t fixedCount_;
  std::vector<Corner> across_;
  std::vector<Corner> cornerOf_;
  std::vector<std::uint8_t> valence_;
  std::vector<VertexId> changed_;
  std::vector<std::uint8_t> grades_;
};

}  // namespace af2
