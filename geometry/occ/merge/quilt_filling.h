// Meshes faces together, within the divided edges around them.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include "geometry/mesh/face_boundary.h"
#include "geometry/mesh/face_mesh.h"
#include "geometry/meshing/face_source.h"
#include "geometry/occ/merge/merge_plan.h"
#include "geometry/occ/sizes/cad_sizes.h"
#include "geometry/sizes/finer_inside.h"

namespace af2::geometry {

struct QuiltTask {
  const Quilt& quilt;
  const CadSizes& sizes;
  const FillRequest& request;
  double expectedElements = 1;
  FinerInside finer = {};
};

/// Throws GeometryError with the reason if nothing works.
void fillQuilt(const QuiltTask& task, FaceMesh& mesh);

}  // namespace af2::geometry
