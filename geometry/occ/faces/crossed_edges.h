// Finds where the edges of a plane face cross in the model itself, however they are divided.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <optional>
#include <string>

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

struct CrossedEdges {
  int one = 0, other = 0;  ///< the same: the edge crosses itself
  Point3 place;
};

/// A place away from the ends of both edges. Many short chords show where it may be, and Newton's
/// method confirms it. None on faces that are not plane.
std::optional<CrossedEdges> crossedEdges(const ModelShape& model, int face);

/// "edge 3 crosses edge 5", "edge 3 crosses itself"
std::string wordsFor(const CrossedEdges& edges);
/// "in the model itself, ..."
std::string textOf(const CrossedEdges& edges);

}  // namespace af2::geometry
