// Boundaries that a rigid motion moves onto each other.
#pragma once

#include <optional>
#include <vector>

#include "engine/base/export.h"
#include "engine/mesh/front_input.h"
#include "geometry/congruence/motion.h"

namespace af2::geometry {

struct Congruence {
  Motion motion;
  bool isReflection = false;       ///< of space: the face is seen in a mirror
  double tolerance = 0;            ///< the largest distance between places that count as one
  std::vector<VertexId> vertices;  ///< by vertex of one boundary: that of the other
};

/// How a boundary lies in space, with what is asked about it again and again.
struct BoundaryForm {
  FrontInput input;
  std::vector<std::vector<double>> lengths;  ///< of the segments, by loop and corner
  /// Three corners of the first loop, far from each other; none: it lies on a line.
  struct Corners {
    std::size_t first = 0, second = 0, third = 0;
    double extent = 0;  ///< the distance between the first two
  };
  std::optional<Corners> corners;
};

AF2_EXPORT BoundaryForm formOf(FrontInput input);

/// A motion that moves one boundary onto another so that corners and normals there are the same.
/// Loops may begin anywhere, and run the other way if the motion is a reflection. Of several
/// motions the first: those without reflection before others, then by the corner of the other
/// boundary at which the first one of this comes to lie. None for boundaries with isolated
/// vertices.
AF2_EXPORT std::optional<Congruence> congruenceOf(const BoundaryForm& one,
                                                  const BoundaryForm& other);

}  // namespace af2::geometry
