// What is wanted of the mesh of a model: a planar domain, a surface of triangles or a CAD model.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/run/algorithm.h"
#include "geometry/charts/chart_kind.h"
#include "geometry/edges/edge_points.h"
#include "geometry/sizes/sizes.h"

namespace af2::geometry {

/// How far the meshing of a model has come. Work is counted in expected elements.
struct ModelProgress {
  double workDone = 0, workTotal = 0;
  int facesDone = 0, faces = 0;
  std::size_t elements = 0;
};

struct MeshingOptions {
  Sizes sizes;
  /// Edges that are divided already, by id: the vertices between their ends, in order along the
  /// edge, one way or the other; none: the edge is a single segment. They are kept as they are.
  EdgePoints edgePoints;
  /// How surfaces are seen. A face whose surface has no such charts, or on which they fail, is
  /// meshed as with ChartKind::Auto; its report tells.
  ChartKind chart = ChartKind::Auto;
  int order = 1;           ///< 2: elements with vertices at the middles of their sides as well
  std::vector<int> faces;  ///< ids of the faces to mesh; empty: all
  int threads = 0;         ///< 0: as many as the machine has. The mesh does not depend on it.
  /// Called from several threads, one at a time.
  std::function<void(const ModelProgress&)> progress;
  bool optimize = true;  ///< swaps and smoothing after the front has closed; false: the raw front
  /// In how many rounds faces that failed or came out poor are tried again; empty: in as many as
  /// usually help.
  std::optional<int> mostRetries;
  std::stop_token stop;
  /// The observer of one face, or null; asked for from the thread that meshes the face.
  std::function<AF2MeshingObserver*(int face)> observer;

  /// Planar domains: their segments are edges of the mesh as they are, however long.
  bool keepBoundary = false;
  /// Surfaces of triangles: edges at which they turn by more than so many degrees are kept.
  double featureAngle = 40;
};

}  // namespace af2::geometry
