// Cuts the part of one process out of a whole mesh.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/io/line_elements.h"
#include "geometry/mpi/partition/divide_mesh.h"
#include "geometry/mpi/partition/owned_part.h"

namespace af2::mpi {

/// By line: the owner of the element beside it.
std::vector<std::int32_t> ownersOfLines(const DividedMesh& divided,
                                        std::span<const geometry::LineElement> lines);

/// Without labels.
///
/// owners  of the lines
OwnedPart cutPart(const DividedMesh& divided, std::span<const geometry::LineElement> lines,
                  std::span<const std::int32_t> owners, int part);

}  // namespace af2::mpi
