// Fine triangles on faces of a model, which fit together at the edges.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "engine/base/point.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Where an edge of the model runs along sides of triangles.
struct EdgePlace {
  int edge = 0;
  std::uint32_t index = 0;  ///< of the piece of the edge, counted from its first vertex
  bool isForward = true;    ///< as the side goes from the lower to the higher vertex
};

struct BackgroundFacets {
  std::vector<Point3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from outside
  std::vector<int> face;                                ///< by triangle
  /// By triangle: the places of its corners in the parameters of the face.
  std::vector<std::array<Point2, 3>> parameters;
  /// By face and side of one of its triangles, the lower vertex first: two edges may have the same
  /// ends, and one piece each.
  struct FaceSide {
    int face = 0;
    std::uint32_t low = 0, high = 0;
    auto operator<=>(const FaceSide&) const = default;
  };
  std::map<FaceSide, EdgePlace> edges;
  std::map<int, std::uint32_t> pieces;  ///< by edge: in how many pieces it is divided
  std::set<int> failed;                 ///< faces without triangles
};

/// Divides the edges of some faces, and fills these.
///
/// deflection  how far triangles may be from their face
BackgroundFacets backgroundOf(const ModelShape& model, const std::vector<int>& faces,
                              double deflection);

}  // namespace af2::geometry
