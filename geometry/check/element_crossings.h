// Finds elements of a mesh that pass through each other or overlap.
#pragma once

#include <array>
#include <vector>

#include "engine/base/export.h"
#include "geometry/check/model_check.h"
#include "geometry/check/repeat.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Two elements that meet where they must not.
struct Crossing {
  std::array<ElementId, 2> elements;  ///< in ascending order
  std::array<int, 2> faces{};         ///< of the model, of these elements
  bool isFold = false;                ///< true: they share an edge and overlap; false: they cross
  Point3 place;
  std::array<double, 2> widths{};  ///< of these elements: the longest distance of two corners
  bool operator==(const Crossing&) const = default;
};

/// All pairs of elements of one piece of the mesh that penetrate each other by more than 1e-9 of
/// its diagonal, or that share an edge and overlap there. The pairs are in the order of the
/// elements, and do not depend on how `repeat` distributes the work.
///
/// Pieces without a common vertex, such as the parts of an assembly, are not compared: if they
/// touch or overlap, the model was made so. The elements of a face must be consecutive and pass
/// checkModelMesh.
AF2_EXPORT std::vector<Crossing> elementCrossings(const ModelMesh& mesh, const Repeat& repeat);

/// A small set of faces, chosen greedily, whose removal leaves no crossing: one finding for each,
/// in the order of the choice. Crossings of faces in `without` (ascending) do not count.
AF2_EXPORT std::vector<MeshFinding> facesThatCross(std::vector<Crossing> crossings,
                                                   const std::vector<int>& without);

}  // namespace af2::geometry
