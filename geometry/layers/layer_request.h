// Layers of quadrilaterals along edges, as they are asked for.
#pragma once

#include <string>
#include <vector>

namespace af2::geometry {

/// Layers along edges, on the faces beside them: for boundary layers of flows.
///
/// The heights are measured from the edge along the surface of the face. Where there is no room,
/// layers become thinner, down to 40 % of their heights, and then fewer. On edges without layers,
/// at which layers end at an angle of 25 to 135 degrees, vertices are placed at the heights of the
/// layers.
struct LayerRequest {
  /// Edges by id and by name: names of boundaries, and of faces and groups, which stand for the
  /// edges that these faces use once. As in Sizes::partSizes, `*` matches any text and `?` any
  /// character. No edges at all: those of `faces`.
  std::vector<int> edges = {};
  std::vector<std::string> edgeNames = {};
  /// Faces that get the layers, by id and by name; none: all that have the edge.
  std::vector<int> faces = {};
  std::vector<std::string> faceNames = {};

  double first = 0;     ///< height of the layer at the edge, in model units, > 0
  double growth = 1.2;  ///< ratio of the heights of successive layers, > 0
  int count = 0;        ///< number of layers, from 1 to kMaxLayers
};

inline constexpr int kMaxLayers = 1000;

}  // namespace af2::geometry
