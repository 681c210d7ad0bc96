// After the front has closed: swaps, collapses, other quadrilaterals and smoothing.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>

#include "engine/base/export.h"
#include "engine/mesh/front_input.h"
#include "engine/mesh/mesh.h"
#include "engine/surface/local_transform.h"

namespace af2 {

struct OptimizeOptions {
  int rounds = 2;           ///< of swapping and smoothing; one more with quadrilaterals
  int smoothingSweeps = 3;  ///< at most, in each round; one less with quadrilaterals
  bool renumber = true;     ///< whether vertices and elements may be taken out and put in
  /// Whether a mesh that comes out unsound is put back as it was. If not, the report tells, and
  /// half of the memory is saved: for those who can make the mesh anew.
  bool keepOriginal = true;
  /// Triangles that this rule made may become quadrilaterals wherever they are: it stands for what
  /// closes a front of quadrilaterals that got stuck. None: only small groups of triangles may.
  std::optional<std::uint16_t> closingRule;
  std::stop_token stop;  ///< what is done so far stays
};

/// What was done.
struct OptimizeReport {
  std::size_t swaps = 0, moves = 0, collapses = 0;
  std::size_t replacements = 0;  ///< of groups with quadrilaterals
  bool isSound = true;           ///< false: the mesh does not pass checkMesh, and was not put back
};

/// Improves the shape of the elements of a complete mesh, in place.
///
/// Never moves or removes the fixed vertices of the boundary, never turns an element over, never
/// leaves the surface: vertices move through charts of `maker`. What comes out is held
/// against checkMesh; should it not pass, the mesh stays as it was. Depends on nothing but its
/// arguments.
AF2_EXPORT OptimizeReport optimizeMesh(Mesh& mesh, const MeshBoundary& boundary,
                                       const AF2LocalTransformMaker& maker,
                                       const OptimizeOptions& options = {});

}  // namespace af2
