// A part of a mesh of quadrilaterals that can be filled anew because its corners are convex.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/mesh/mesh_topology.h"
#include "engine/optimize/patch_editor.h"

namespace af2 {

/// The outline of a region.
struct RegionRing {
  std::vector<VertexId> vertices;    ///< counter-clockwise
  std::vector<std::size_t> corners;  ///< places in `vertices`, in order
};

/// A set of elements that grows until a grid or a star fits in its outline: each vertex of the
/// outline would be regular with one or two quadrilaterals of the region.
class QuadRegion {
 public:
  QuadRegion(const PatchEditor& editor, std::size_t mostElements)
      : editor_(editor), topology_(editor.topology()), mostElements_(mostElements) {}

  void clear();
  /// Adds the elements around a vertex.
  void addStar(VertexId v);
  /// Adds the elements around the outline.
  void addLayer();
  /// Adds elements where the outline is not convex. Returns false if the region would become too
  /// large, or cannot become convex.
  bool makeConvex();
  /// The outline of a convex region; none if it is no single ring.
  std::optional<RegionRing> ring() const;

  const std::vector<std::size_t>& elements() const { return elements_; }
  bool has(std::size_t element) const { return element < isIn_.size() && isIn_[element]; }

 private:
  struct Place {
    VertexId vertex;
    int outside;  ///< number of elements at the vertex that do not belong to the region
  };
  enum class Growth { Done, More, Impossible };

  void add(std::size_t element);
  Growth growOnce();
  void findOutline();
  int wantedInside(const Place& place) const;

  const PatchEditor& editor_;
  const MeshTopology& topology_;
  std::size_t mostElements_;
  std::vector<std::size_t> elements_;
  std::vector<std::uint8_t> isIn_;  ///< by element of the mesh
  std::vector<Corner> outline_;     ///< the sides of elements beyond which the region ends
};

}  // namespace af2
