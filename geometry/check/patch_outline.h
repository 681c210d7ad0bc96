// Whether a part of a mesh projects to a plane or a sphere without overlaps: then it cannot cross
// itself.
// Not installed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/base/box_tree.h"
#include "geometry/check/repeat.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

class StarShape;

/// Data collected in one pass over consecutive elements of a face.
struct OutlinedPatch {
  /// The number of elements that share a box.
  static constexpr std::size_t kRun = 64;
  using Side = std::pair<std::uint32_t, std::uint32_t>;

  std::size_t first = 0, last = 0;  ///< the elements: from the first to before the last
  Box3 box;
  std::vector<Box3> boxes;  ///< of each kRun elements
  Point3 normal;            ///< the sum of their normals, each as long as twice the area
  Point3 corners;           ///< the sum of their first corners
  std::vector<Side> sides;  ///< those along segments, directed as in their elements; sorted
  std::vector<std::uint32_t> onSegments;  ///< vertices on segments, possibly repeated
};

/// Whether each of some directed sides along segments is there in the other direction, too.
bool areClosed(std::vector<OutlinedPatch::Side> sides);

/// The segments of a mesh, for checking its patches.
class PatchOutlines {
 public:
  /// repeat  for the elements of large patches; must outlive this
  PatchOutlines(const ModelMesh& mesh, const Repeat& repeat);

  OutlinedPatch patch(std::size_t first, std::size_t last) const;

  /// For a patch of one face: whether all of its elements face one side of some plane, and its
  /// boundary along the segments of the mesh, projected to the plane, consists of simple loops that
  /// do not cross. Then each point of the plane is below at most one element. False proves nothing.
  bool canBeDrawn(const OutlinedPatch& patch) const;

  /// Whether the elements of some patches, of any faces, form a closed surface, all face away from
  /// one point or all towards it, and enclose it once: then each ray from that point meets one of
  /// them. False proves nothing.
  bool isStarShaped(std::span<const OutlinedPatch* const> patches) const;

 private:
  using Side = OutlinedPatch::Side;
  using Loops = std::vector<std::vector<std::uint32_t>>;  ///< of vertices

  OutlinedPatch partOf(std::size_t first, std::size_t last) const;
  bool allAreIn(StarShape& star, const OutlinedPatch& patch) const;
  bool allFace(const OutlinedPatch& patch, const Point3& normal) const;
  void addRun(std::size_t begin, std::size_t end, OutlinedPatch& patch) const;
  void addAtSegments(std::span<const VertexId> corners, OutlinedPatch& patch) const;
  std::optional<Loops> outline(const std::vector<Side>& sides) const;
  bool isSegment(std::uint32_t a, std::uint32_t b) const;

  const ModelMesh& mesh_;
  const Repeat& repeat_;
  std::vector<std::uint8_t> isOnSegment_;  ///< by vertex
  std::vector<Side> segments_;             ///< the lower vertex first; sorted
};

}  // namespace af2::geometry
