// Whether a part of a mesh can be drawn in a plane or on a sphere without overlaps: then it cannot
// cross itself.
// Not installed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/base/box_tree.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// What one walk over the elements of a face, or some of them in a row, tells of them.
struct Patch {
  /// How many elements have a box in common.
  static constexpr std::size_t kRun = 64;
  using Side = std::pair<std::uint32_t, std::uint32_t>;

  std::size_t first = 0, last = 0;  ///< the elements: from the first to before the last
  Box3 box;
  std::vector<Box3> boxes;  ///< of each kRun elements
  Point3 normal;            ///< the sum of their normals, each as long as twice the area
  Point3 corners;           ///< the sum of their first corners
  std::vector<Side> sides;  ///< those along segments, as the elements run along them; sorted
  std::vector<std::uint32_t> onSegments;  ///< vertices on segments, once or more often
};

/// The segments of a mesh, to hold its patches against.
class PatchOutlines {
 public:
  explicit PatchOutlines(const ModelMesh& mesh);

  Patch patch(std::size_t first, std::size_t last) const;

  /// Of a patch of one face: whether all of its elements look to one side of some plane, and the
  /// boundary between them and the segments of the mesh, drawn in it, is made of simple loops that
  /// do not cross. Then each point of the plane is below one element at most. False says nothing.
  bool canBeDrawn(const Patch& patch) const;

  /// Whether the elements of some patches, of any faces, are closed and all look away from one
  /// point, or all towards it, and go around it once: then each ray from there meets one of them.
  /// False says nothing.
  bool isStarShaped(std::span<const Patch* const> patches) const;

 private:
  using Side = Patch::Side;
  using Loops = std::vector<std::vector<std::uint32_t>>;  ///< of vertices

  void addRun(std::size_t begin, std::size_t end, Patch& patch) const;
  void addAtSegments(std::span<const VertexId> corners, Patch& patch) const;
  std::optional<Loops> outline(const std::vector<Side>& sides) const;
  bool isSegment(std::uint32_t a, std::uint32_t b) const;

  const ModelMesh& mesh_;
  std::vector<std::uint8_t> isOnSegment_;  ///< by vertex
  std::vector<Side> segments_;             ///< the lower vertex first; sorted
};

}  // namespace af2::geometry
