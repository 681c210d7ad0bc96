// From a surface of triangles to a checked mesh of its smooth patches.
#pragma once

#include <limits>
#include <stop_token>

#include "engine/algorithm.h"
#include "geometry/faceted/facets.h"
#include "geometry/model_mesh.h"
#include "geometry/position_size.h"
#include "geometry/size_sources.h"

namespace af2::geometry {

struct FacetedMeshingOptions {
  double size = 0;  ///< wanted edge length, > 0
  /// Bounds of all wanted sizes, however they come about.
  double minSize = 0, maxSize = std::numeric_limits<double>::infinity();
  SizeSources sources;    ///< points, boxes and background fields
  PositionSize function;  ///< further limit by position
  /// How many elements go around a full turn, by the normals of the triangles; 0: eight or so, but
  /// no smaller than a third of the size.
  double elementsPerTurn = 0;
  /// Most growth of the size per unit of length, away from whatever wants a small one.
  double growth = kDefaultGrowth;
  /// Edges at which the surface turns by more than so many degrees are kept.
  double featureAngle = 40;
  bool optimize = true;  ///< swaps and smoothing after the front has closed
  ProgressCallback progress;
  std::stop_token stop;
};

/// Meshes each patch between feature edges, which are divided once and shared. Patches are faces:
/// 1, 2, ... in the order of their first triangles. New vertices lie on the triangles.
///
/// A patch that cannot be meshed is reported as failed and does not spoil the others.
///
/// Throws InputError for a size that is not positive, or if neighbouring triangles are turned
/// against each other.
ModelMesh meshFaceted(const Facets& facets, const AF2Algorithm& algorithm,
                      const FacetedMeshingOptions& options);

}  // namespace af2::geometry
