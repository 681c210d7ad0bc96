// Where elements of a mesh pass through each other or lie on each other.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "engine/base/export.h"
#include "geometry/check/model_check.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Two elements that meet where they must not.
struct Crossing {
  std::array<ElementId, 2> elements;  ///< in ascending order
  std::array<int, 2> faces{};         ///< of the model, of these elements
  bool isFold = false;  ///< they share an edge, and one lies on the other; else they cross
  Point3 place;
  bool operator==(const Crossing&) const = default;
};

/// Calls work(0), ..., work(count - 1), perhaps several at once.
using Repeat = std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)>;

/// All pairs of elements of one piece of the mesh that reach into each other by more than a
/// thousand-millionth of its diagonal, or that share an edge and lie on each other there. In the
/// order of the elements; it does not depend on how `repeat` goes about it.
///
/// Pieces without a common vertex, as the parts of an assembly, are not held against each other:
/// that they touch or overlap is how the model was made. The elements of a face must lie in a row
/// and pass checkModelMesh.
AF2_EXPORT std::vector<Crossing> elementCrossings(const ModelMesh& mesh, const Repeat& repeat);

/// The fewest faces, as a greedy choice finds them, without which no crossing is left: one finding
/// for each, in the order of their choice. Crossings of faces in `without` (ascending) do not
/// count.
AF2_EXPORT std::vector<MeshFinding> facesThatCross(std::vector<Crossing> crossings,
                                                   const std::vector<int>& without);

}  // namespace af2::geometry
