// From a planar domain to a checked mesh, without a CAD kernel.
#pragma once

#include <limits>
#include <stop_token>

#include "engine/algorithm.h"
#include "geometry/model_mesh.h"
#include "geometry/planar/poly_file.h"
#include "geometry/position_size.h"
#include "geometry/size_sources.h"

namespace af2::geometry {

struct PlanarMeshingOptions {
  double size = 0;  ///< wanted edge length, > 0
  /// Bounds of all wanted sizes, however they come about.
  double minSize = 0, maxSize = std::numeric_limits<double>::infinity();
  SizeSources sources;    ///< points, boxes and background fields
  PositionSize function;  ///< further limit by position
  /// How many segments go around a full turn of a curved boundary; 0: eight or so.
  double elementsPerTurn = 0;
  /// How many elements lie across what is narrow; 0: it does not matter (see ModelSizes).
  double elementsAcross = 0;
  /// Most growth of the size per unit of length, away from whatever wants a small one.
  double growth = kDefaultGrowth;
  /// The segments of the domain are edges of the mesh as they are, however long.
  bool keepBoundary = false;
  int order = 1;         ///< 2: elements with vertices at the middles of their sides as well
  bool optimize = true;  ///< swaps and smoothing after the front has closed
  int threads = 0;       ///< 0: as many as the machine has. The mesh does not depend on it.
  ProgressCallback progress;
  std::stop_token stop;
  AF2MeshingObserver* observer = nullptr;
};

/// Meshes the regions that the segments bound: the outside and the regions of hole points are left
/// out. Each connected region is a face: 1, 2, ... in the order of its lowest, then leftmost
/// vertex. Segments inside a region are kept as edges of the mesh.
///
/// Throws InputError if segments cross, if they enclose nothing, or if a size is not positive.
ModelMesh meshPlanar(const PlanarDomain& domain, const AF2Algorithm& algorithm,
                     const PlanarMeshingOptions& options);

}  // namespace af2::geometry
