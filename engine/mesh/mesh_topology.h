// Which elements lie side by side, for the optimiser: a corner table that swaps and collapses keep.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/mesh/front_input.h"
#include "engine/mesh/mesh.h"

namespace af2 {

/// One corner of one element; also the side that runs from there to the next corner.
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
/// their sides: nothing is swapped or walked across them.
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
  /// The same side seen from the other element, where it runs the other way; none at the rim.
  Corner across(Corner c) const { return across_[static_cast<std::size_t>(c.code)]; }
  /// The corner of the same vertex in the next element counter-clockwise; none at the rim.
  Corner aroundVertex(Corner c) const { return across(previous(c)); }
  /// A corner of the vertex, at the rim the first counter-clockwise; none: no element uses it.
  Corner cornerOf(VertexId v) const { return cornerOf_[v.value]; }

  /// Elements at a vertex, up to 255.
  int valence(VertexId v) const { return valence_[v.value]; }
  bool isFixed(VertexId v) const { return v.value < fixedCount_; }
  std::size_t fixedCount() const { return fixedCount_; }
  bool isDead(std::size_t element) const { return mesh_.elements[element].corners[0].isNone(); }

  /// The angle of the mesh at each fixed vertex, in radians.
  std::vector<double> anglesAtFixed() const;

  /// Whether an element side joins the two vertices.
  bool areJoined(VertexId u, VertexId v) const;

  /// Turns the side shared by two triangles: (a, b, c), (b, a, d) become (a, d, c), (d, b, c).
  void swap(Corner side);
  /// Moves the inner vertex at the start of a side into that at its end; the elements on both sides
  /// of it, triangles, vanish.
  void collapse(Corner side);
  /// Puts elements into the places of others that cover the same part of the surface, and behind
  /// all others if they are more; places that are left over are dead, as is a vertex that no
  /// element uses any more. Returns where the elements are.
  std::vector<std::size_t> replace(std::vector<std::size_t> places,
                                   std::span<const Element> elements);
  /// The vertices of all elements that were changed since this was last asked, in no order and
  /// perhaps several times.
  std::vector<VertexId> takeChanged() { return std::exchange(changed_, {}); }
  /// Takes out what collapses left dead; the topology is of no use afterwards.
  void compact();

 private:
  void setAcross(Corner c, Corner d);
  void cutAt(const MeshBoundary& boundary);
  void findCorners();
  void renewCornerOf(Corner c);
  void noteChange(std::size_t element) {
    const auto vertices = mesh_.elements[element].vertices();
    changed_.insert(changed_.end(), vertices.begin(), vertices.end());
  }

  Mesh& mesh_;
  std::size_t fixedCount_;
  std::vector<Corner> across_;
  std::vector<Corner> cornerOf_;
  std::vector<std::uint8_t> valence_;
  std::vector<VertexId> changed_;
};

}  // namespace af2
