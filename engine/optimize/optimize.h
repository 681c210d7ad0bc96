// Optimises a complete mesh: swaps, collapses, quadrilateral replacements and smoothing.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>

#include "engine/base/export.h"
#include "engine/mesh/front_input.h"
#include "engine/mesh/mesh.h"
#include "engine/optimize/finish_observer.h"
#include "engine/surface/local_transform.h"

namespace af2 {

/// How thoroughly a mesh with quadrilaterals is cleaned up.
struct QuadCleanUp {
  /// The largest number of changes in a sequence that removes irregular vertices; 0: none. No
  /// value: what the rule set says, else kUsualDepth.
  std::optional<int> depth;
  static constexpr int kUsualDepth = 2;
  /// Whether triangles are joined in pairs, however far apart they are, until at most one is left.
  bool onlyQuads = false;
  int usedDepth() const { return depth.value_or(kUsualDepth); }
  bool operator==(const QuadCleanUp&) const = default;
};

struct OptimizeOptions {
  int rounds = 2;           ///< of swapping and smoothing; one more with quadrilaterals
  int smoothingSweeps = 3;  ///< maximum in each round; one less with quadrilaterals
  bool renumber = true;     ///< whether vertices and elements may be removed and added
  /// Whether the original mesh is restored if the result is not sound. If not, the report says so
  /// and the memory of a copy is saved, for callers that can mesh again.
  bool keepOriginal = true;
  /// Triangles made by this rule may become quadrilaterals everywhere: it is the rule that fills a
  /// front of quadrilaterals that got stuck. None: only small groups of triangles may.
  std::optional<std::uint16_t> closingRule;
  QuadCleanUp quads;
  std::stop_token stop;  ///< changes made so far are kept
  /// Called again and again during the work, from its thread: a sign that it goes on.
  std::function<void()> goesOn;
  FinishObserver* observer = nullptr;
};

/// Counts of the changes made.
struct OptimizeReport {
  std::size_t swaps = 0, moves = 0, collapses = 0;
  std::size_t replacements = 0;  ///< of groups of elements, with quadrilaterals
  bool isSound = true;           ///< false: the mesh fails checkMesh and was not restored
};

/// Improves the shapes of the elements of a complete mesh, in place.
///
/// Fixed boundary vertices are never moved or removed, elements are never inverted, and vertices
/// move through charts of `maker`, so they stay on the surface. The result is tested with
/// checkMesh; if it fails, the original mesh is restored. Depends only on its arguments.
AF2_EXPORT OptimizeReport optimizeMesh(Mesh& mesh, const MeshBoundary& boundary,
                                       const AF2LocalTransformMaker& maker,
                                       const OptimizeOptions& options = {});

/// Joins the triangles of a complete mesh in pairs, in place, moving them through quadrilaterals.
/// Where boundaries of the region have even numbers of edges, few meshes keep a triangle. As in
/// optimizeMesh, the mesh stays as it was if the result is not sound.
///
/// Returns the number of pairs.
AF2_EXPORT std::size_t joinTriangles(Mesh& mesh, const MeshBoundary& boundary,
                                     const AF2LocalTransformMaker& maker,
                                     const std::stop_token& stop = {},
                                     const std::function<void()>& goesOn = {});

}  // namespace af2
