// The physical groups of a mesh in parts.
#pragma once

#include <span>

#include "geometry/io/line_elements.h"
#include "geometry/mpi/partition/owned_part.h"

namespace af2::mpi {

PartLabels labelsOf(const geometry::ModelMesh& mesh, std::span<const geometry::LineElement> lines);

}  // namespace af2::mpi
