// Whether a part of a mesh can be drawn in a plane or on a sphere without overlaps: then it cannot
// cross itself.
// Not installed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/model_mesh.h"

namespace af2::geometry {

class PatchOutlines {
 public:
  explicit PatchOutlines(const ModelMesh& mesh);

  /// Elements from `first` to before `last`, all of one face: whether all of them look to one side
  /// of some plane, and the boundary between them and the segments of the mesh, drawn in it, is
  /// made of simple loops that do not cross. Then each point of the plane is below one element at
  /// most. False says nothing.
  bool canBeDrawn(std::size_t first, std::size_t last) const;

  /// Elements in a row: from the first to before the second.
  using Range = std::pair<std::size_t, std::size_t>;

  /// Whether elements, of any faces, are closed and all look away from one point, or all towards
  /// it, and go around it once: then each ray from there meets one of them. False says nothing.
  bool isStarShaped(std::span<const Range> ranges) const;

 private:
  using Side = std::pair<std::uint32_t, std::uint32_t>;
  using Loops = std::vector<std::vector<std::uint32_t>>;  ///< of vertices

  /// The sides along segments, as the elements run along them; sorted.
  std::vector<Side> sidesOnSegments(std::span<const Range> ranges) const;
  /// Whether each segment that elements use is used by them in both directions.
  bool isClosed(std::span<const Range> ranges) const;
  std::optional<Loops> outline(std::size_t first, std::size_t last) const;
  bool isSegment(std::uint32_t a, std::uint32_t b) const;

  const ModelMesh& mesh_;
  std::vector<std::uint8_t> isOnSegment_;  ///< by vertex
  std::vector<Side> segments_;             ///< the lower vertex first; sorted
};

}  // namespace af2::geometry
