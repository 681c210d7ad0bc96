// How edges are divided where creases of their faces end on them.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <functional>
#include <map>

#include "geometry/occ/edges/edge_parts.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// An edge across a crease turns with it. That counts for nothing, as the crease is an edge.
class CreaseReach {
 public:
  CreaseReach() = default;
  /// pointOf  the point that a vertex of the model has become, both counted from 0
  CreaseReach(const ModelShape& model,
              const std::function<std::uint32_t(std::uint32_t vertex)>& pointOf);

  /// How far from a point, at which a crease ends, edges across it turn.
  const std::map<std::uint32_t, double>& byPoint() const { return byPoint_; }

  /// Takes the limits by turns from the ends of a part.
  void leaveOut(EdgePart& part) const;

 private:
  double at(std::uint32_t point) const;

  std::map<std::uint32_t, double> byPoint_;
};

}  // namespace af2::geometry
