// The directed loops around a face, made of divided edges.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/mesh/front_input.h"
#include "engine/mesh/mesh.h"
#include "geometry/mesh/layers_along_edge.h"

namespace af2::geometry {

/// One segment of an edge, in the direction in which a face uses it.
struct SegmentUse {
  int edge = 0;
  std::uint32_t segment = 0;
};

struct FaceBoundary {
  FrontInput input;  ///< without loops if the face has no width: its boundary runs back on itself
  /// By vertex id: index into DividedEdges::points. Higher vertex ids belong to the rims of fans
  /// and to the tops of layers.
  std::vector<std::uint32_t> points;
  std::vector<SegmentUse> uses;
  bool closedInParameters = true;    ///< the loops are closed curves in (u, v), too
  bool canBeCut = true;              ///< they are, except at poles: lines in (u, v) cut the face
  std::vector<std::string> repairs;  ///< faults that were repaired
  std::vector<std::string> notes;    ///< other remarks
  std::vector<int> pointEdges;       ///< edges that count as points
  /// Edges that coincide along part or all of their length, with no room between them.
  struct TouchingEdges {
    int one = 0, other = 0;
    double gap = 0;     ///< their distance
    double length = 0;  ///< of the part
  };
  std::vector<TouchingEdges> touching;
  /// Ready-made triangles around a sharp tip of the surface. The loops exclude them.
  struct Fan {
    std::uint32_t tip = 0;      ///< index into DividedEdges::points
    SurfacePoint place;         ///< of the tip
    std::vector<VertexId> rim;  ///< of the loop that excludes the fan, in its direction
  };
  std::vector<Fan> fans;
  /// Ready-made layers along edges. The loops run along their tops.
  struct Layers {
    /// Vertices that no loop has any more: their ids follow those of the input. First those of the
    /// boundary, as indices into DividedEdges::points, with their places; then those inside.
    std::vector<std::uint32_t> points = {};
    std::vector<SurfacePoint> places = {}, inside = {};
    std::vector<Element> elements = {};
    double area = 0;
    std::vector<LayersAlongEdge> along = {};  ///< by edge, ascending
  };
  std::optional<Layers> layers;  ///< none: they were not asked for
};

}  // namespace af2::geometry
