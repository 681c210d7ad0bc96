// Cuts the parts of a divided mesh, face by face.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/io/line_elements.h"
#include "geometry/mpi/partition/divide_mesh.h"
#include "geometry/mpi/partition/part_piece.h"

namespace af2::mpi {

using TakePiece = std::function<void(int part, PartPiece&& piece)>;

/// Calls `take` with the pieces of each part in the order of their elements. Returns, by part, what
/// is left to tell; without labels.
///
/// lines  sides of elements
std::vector<PartEnd> cutParts(const geometry::ModelMesh& mesh, const MeshDivision& division,
                              std::span<const geometry::LineElement> lines, const TakePiece& take);

}  // namespace af2::mpi
