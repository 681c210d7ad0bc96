// Finds where a mesh is too coarse for narrow strips of faces, walls and gaps.
#pragma once

#include <vector>

#include "geometry/mesh/model_mesh.h"
#include "geometry/sizes/growing_size.h"

namespace af2::geometry {

/// Places at which fewer than `elementsAcross` elements of the wanted sizes fit between opposite
/// boundaries of a face, or between opposite elements of a wall or a gap, each with the size at
/// which that many fit. Measures the distance from the middle of each boundary edge across its
/// face, and from the middle of each element along its normal, in both directions; edges or
/// elements that share a vertex are not opposite to each other. The accuracy depends on the size of
/// the elements.
///
/// mesh     must contain its wanted sizes
/// threads  the maximum number; 0: as many as the caller's TBB arena has
std::vector<SizeSource> narrowPlaces(const ModelMesh& mesh, double elementsAcross, int threads = 1);

}  // namespace af2::geometry
