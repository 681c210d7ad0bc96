#include "geometry/occ/run/mesh_model.h"

#include "geometry/meshing/mesh_faces.h"
#include "geometry/occ/run/cad_faces.h"

namespace af2::geometry {

ModelMesh meshModel(const Model& model, const AF2Algorithm& algorithm,
                    const MeshingOptions& options, const TurnLimits& turns) {
  CadFaces faces(model, turns);
  return meshFaces(faces, algorithm, options);
}

}  // namespace af2::geometry
