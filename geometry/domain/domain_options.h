// What is wanted of the mesh of a planar domain or of a surface of triangles.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/run/algorithm.h"
#include "geometry/charts/chart_kind.h"
#include "geometry/edges/edge_points.h"
#include "geometry/sizes/position_size.h"
#include "geometry/sizes/size_sources.h"

namespace af2::geometry {

/// Lengths are in model units.
struct DomainMeshingOptions {
  double size = 0;  ///< wanted edge length, > 0
  /// Bounds of all wanted sizes, however they come about.
  double minSize = 0, maxSize = std::numeric_limits<double>::infinity();
  std::map<int, double> faceSizes;  ///< by face id; instead of `size`
  std::map<int, double> edgeSizes;  ///< by edge id; along that edge, instead of the faces' sizes
  /// By name of a face or group; `*` is any text, `?` any character. `faceSizes` count more, and of
  /// several that fit the last.
  std::vector<std::pair<std::string, double>> partSizes;
  SizeSources sources;    ///< points, boxes and background fields
  PositionSize function;  ///< further limit by position
  /// How many elements go around a full turn of what is curved; 0: eight or so.
  double elementsPerTurn = 0;
  /// How many elements lie across what is narrow; 0: it does not matter (see ModelSizes).
  double elementsAcross = 0;
  /// Most growth of the size per unit of length, away from whatever wants a small one.
  double growth = kDefaultGrowth;
  /// Edges that are divided already, by id: the vertices between their ends, in order along the
  /// edge, one way or the other. They are kept as they are.
  EdgePoints edgePoints;
  std::vector<int> faces;             ///< ids of the faces to mesh; empty: all
  ChartKind chart = ChartKind::Auto;  ///< how curved faces are seen (see ModelMeshingOptions)
  int order = 1;         ///< 2: elements with vertices at the middles of their sides as well
  bool optimize = true;  ///< swaps and smoothing after the front has closed
  /// In how many rounds faces that failed or came out poor are tried again; empty: as many as for
  /// CAD models.
  std::optional<int> mostRetries;
  int threads = 0;  ///< 0: as many as the machine has. The mesh does not depend on it.
  ProgressCallback progress;
  std::stop_token stop;
  AF2MeshingObserver* observer = nullptr;  ///< with one, faces are meshed one after the other
};

}  // namespace af2::geometry
