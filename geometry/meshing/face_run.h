// One run over the faces of a source. Not installed.
#pragma once

#include "geometry/meshing/chord_rounds.h"
#include "geometry/meshing/face_crew.h"
#include "geometry/meshing/face_source.h"
#include "geometry/meshing/meshing_options.h"

namespace af2::geometry {

/// Divides the edges, meshes the faces with all remedies, joins and checks them.
MeasuredMesh meshOnce(FaceSource& source, const AF2Algorithm& algorithm,
                      const MeshingOptions& options);

/// Meshes what the leader of the crew tells in such a run.
void followOnce(FaceSource& source, const AF2Algorithm& algorithm, const MeshingOptions& options,
                CrewFollower& crew);

}  // namespace af2::geometry
