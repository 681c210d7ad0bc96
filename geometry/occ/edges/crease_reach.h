// Divides edges where creases of their faces end on them.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <functional>
#include <map>

#include "geometry/occ/edges/edge_parts.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// An edge that crosses a crease turns there. This turn does not limit the sizes, because the
/// crease itself is an edge of the mesh.
class CreaseReach {
 public:
  CreaseReach() = default;
  /// pointOf  the point for a vertex of the model, both counted from 0
  CreaseReach(const ModelShape& model,
              const std::function<std::uint32_t(std::uint32_t vertex)>& pointOf);

  /// By point at which a crease ends: the distance within which edges turn with the crease.
  const std::map<std::uint32_t, double>& byPoint() const { return byPoint_; }

  /// Removes the limits by turns from the ends of a part.
  void leaveOut(EdgePart& part) const;

 private:
  double at(std::uint32_t point) const;

  std::map<std::uint32_t, double> byPoint_;
};

}  // namespace af2::geometry
