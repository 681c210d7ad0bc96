#include "geometry/occ/merge/mesh_merged.h"

#include "engine/base/error.h"
#include "geometry/meshing/check_options.h"
#include "geometry/meshing/mesh_faces.h"
#include "geometry/occ/merge/merged_faces.h"

namespace af2::geometry {

namespace {

void check(const Model& model, const MeshingOptions& options, const MergeRequest& request) {
  constexpr double kMaxAngle = 60, kMaxNarrow = 0.5;
  if (!(request.angle > 0 && request.angle <= kMaxAngle))
    throw InputError("the angle up to which faces are merged must be between 0 and 60 degrees");
  if (!(request.narrow >= 0 && request.narrow <= kMaxNarrow))
    throw InputError("the share of the size below which faces are narrow must be from 0 to 0.5");
  for (const int edge : request.keptEdges)
    if (edge < 1 || edge > model.edgeCount())
      throw InputError("the model has no edge " + std::to_string(edge) + " that could be kept");
  if (options.fewest)
    throw InputError("merged faces cannot have as few triangles as a bound allows");
  if (options.spool.when == SpoolRequest::When::Always)
    throw InputError("a mesh that is put on disk face by face cannot have merged faces");
}

}  // namespace

ModelMesh meshMerged(const Model& model, const AF2Algorithm& algorithm, const MeshingOptions& asked,
                     const MergeRequest& request, const TurnLimits& turns) {
  check(model, asked, request);
  constexpr int kMostRounds = 12;
  MeshingOptions options = asked;
  options.spool = {};
  MergedFaces faces(model, request, turns);
  ModelMesh mesh = meshFaces(faces, algorithm, options);
  for (int round = 1; round < kMostRounds && faces.cutFailed(mesh); ++round)
    mesh = meshFaces(faces, algorithm, options);
  if (failedFaces(mesh) > 0 && !options.stop.stop_requested()) {
    faces.retryLonger();
    mesh = meshFaces(faces, algorithm, options);
  }
  faces.spread(mesh);
  return mesh;
}

Merging mergingOf(const Model& model, const MeshingOptions& options, const MergeRequest& request,
                  const TurnLimits& turns) {
  check(model, options, request);
  MergedFaces faces(model, request, turns);
  checkOptions(faces, options);
  const MeshingOptions own = optionsFor(faces, options);
  faces.prepare(own, facesAskedFor(faces, own));
  return faces.merging({});
}

}  // namespace af2::geometry
