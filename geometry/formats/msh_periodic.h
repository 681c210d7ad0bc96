// The section of Gmsh's format, version 4.1, about periodic faces.
// Not installed.
#pragma once

#include "geometry/io/output_file.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Nothing if the mesh has no periodic faces.
void writeMshPeriodic(const ModelMesh& mesh, OutputFile& file);

}  // namespace af2::geometry
