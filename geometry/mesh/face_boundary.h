// The directed loops around a face, made of divided edges.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/mesh/front_input.h"

namespace af2::geometry {

/// One segment of an edge as a face runs along it.
struct SegmentUse {
  int edge = 0;
  std::uint32_t segment = 0;
};

struct FaceBoundary {
  FrontInput input;  ///< without loops: the face has no width, its boundary runs back on itself
  /// By vertex id: index into DividedEdges::points. Vertices beyond are those of the rims of fans.
  std::vector<std::uint32_t> points;
  std::vector<SegmentUse> uses;
  bool closedInParameters = true;    ///< the loops are closed curves in (u, v), too
  bool canBeCut = true;              ///< they are, but for poles: lines in (u, v) cut the face
  std::vector<std::string> repairs;  ///< what was not as it should be and was put right
  std::vector<std::string> notes;    ///< what else is worth telling
  std::vector<int> pointEdges;       ///< taken for points
  /// Edges that lie on each other along a part of their length or all of it, with no room between.
  struct TouchingEdges {
    int one = 0, other = 0;
    double gap = 0;     ///< how far they are apart
    double length = 0;  ///< of the part
  };
  std::vector<TouchingEdges> touching;
  /// Ready-made triangles around a sharp tip of the surface, which the loops leave out.
  struct Fan {
    std::uint32_t tip = 0;      ///< index into DividedEdges::points
    SurfacePoint place;         ///< of the tip
    std::vector<VertexId> rim;  ///< of the loop that leaves the fan out, as it runs
  };
  std::vector<Fan> fans;
};

}  // namespace af2::geometry
