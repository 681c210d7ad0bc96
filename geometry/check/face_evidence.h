// What the checks of a whole mesh need to know of one of its faces, once that lies on disk.
// Not installed.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/check/model_check.h"
#include "geometry/check/patch_outline.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Vertices are numbered as in the face: first those of its boundary.
struct FaceEvidence {
  std::vector<MeshFinding> findings;  ///< about single elements
  double area = 0;                    ///< of the elements
  /// Whether all corners are right, and the elements at each vertex inside surround it: then only
  /// sides between vertices of the boundary can be wrong.
  bool isSoundInside = true;
  /// The elements with at least two corners on the boundary, if the face is sound inside.
  std::vector<Element> atBoundary;

  // Only if elements may cross:
  OutlinedPatch patch;
  std::array<Point3, 4> firstCorners{};  ///< of the first element
  bool canBeDrawn = false;               ///< as PatchOutlines says
  bool isStarShaped = false;             ///< by itself, if it cannot be drawn
};

/// Checks a face by itself.
///
/// face      its elements, with its boundary as segments
/// boundary  the number of vertices of the boundary, which come first
FaceEvidence evidenceOf(const ModelMesh& face, std::size_t boundary, bool mayCross);

}  // namespace af2::geometry
