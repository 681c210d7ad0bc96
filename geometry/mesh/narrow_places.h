// Where a mesh is too coarse for what is narrow: strips of faces, walls and gaps.
#pragma once

#include <vector>

#include "geometry/mesh/model_mesh.h"
#include "geometry/sizes/growing_size.h"

namespace af2::geometry {

/// Places at which fewer than `elementsAcross` elements of the wanted sizes lie between opposite
/// boundaries of a face, or between opposite elements of a wall or a gap, each with the size that
/// would make it so many. Asks how far it is from the middle of each boundary edge across its face,
/// and from the middle of each element along its normal, both ways; things that meet in a vertex
/// are not opposite to each other. Only as exact as the elements are small.
///
/// mesh     must know its wanted sizes
/// threads  at most so many; 0: as many as the caller's TBB arena has
std::vector<SizeSource> narrowPlaces(const ModelMesh& mesh, double elementsAcross, int threads = 1);

}  // namespace af2::geometry
