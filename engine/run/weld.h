// Welding: the far ends of two neighbouring front edges become one vertex.
// Not installed.
#pragma once

#include <optional>
#include <vector>

#include "engine/run/advance.h"

namespace af2 {

/// A weld that keeps the mesh and the front sound.
struct Weld {
  PlaceId first, last;          ///< first -> middle -> last are the two edges
  VertexId from, into;          ///< `into` remains
  SurfacePoint point;           ///< where it will be
  std::vector<PlaceId> places;  ///< all other places of the two vertices
};

/// Tests everything ahead of the act, so that nothing has to be undone: not both vertices are given
/// ones, the loop has more than four edges, no element and no neighbour but the middle one belongs
/// to both, all elements keep a scaled Jacobian of 0.1, and no front edge would pass over another.
///
/// first      the place of the first edge
/// takesLast  whether the vertex at the end of the second edge remains; a given vertex always does,
///            at its place
/// point      where the vertex is to be, unless it is a given one
std::optional<Weld> planWeld(const Advance& advance, const StepChart& chart, PlaceId first,
                             bool takesLast, const SurfacePoint& point);

/// `change` lists the edges that leave and join the front.
void apply(Advance& advance, const Weld& weld, Front::Change& change);

}  // namespace af2
