// Meshes one face within its divided edges.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <optional>
#include <vector>

#include "geometry/congruence/face_outline.h"
#include "geometry/layers/layer_heights.h"
#include "geometry/mesh/face_mesh.h"
#include "geometry/meshing/face_source.h"
#include "geometry/occ/faces/face_boundary.h"
#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/sizes/cad_sizes.h"
#include "geometry/sizes/finer_inside.h"

namespace af2::geometry {

struct FaceMeshingContext {
  const ModelShape& model;
  const CadSizes& sizes;  ///< with the sizes by position of this try
  const std::vector<FaceOnFace>& onFaces;
  FinerInside finer = {};  ///< see FaceTask
  const FillRequest& request;
  const EdgeLayers* layers = nullptr;  ///< of the face; null: none
};

/// Throws GeometryError if the face is faulty.
void meshFace(const FaceMeshingContext& context, int face, double area, double expectedElements,
              FaceMesh& mesh);

/// See FaceSource::outlineOf.
std::optional<FaceOutline> outlineOf(const FaceMeshingContext& context, int face, double area);

}  // namespace af2::geometry
