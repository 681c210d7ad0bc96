// Makes meshes until one is as near to the model as it shall be.
// Not installed.
#pragma once

#include <functional>

#include "geometry/deviation/measured_mesh.h"
#include "geometry/meshing/face_source.h"

namespace af2::geometry {

/// A mesh with what its distance from the model was measured with.
struct MeasuredMesh {
  ModelMesh mesh;
  EdgeCurves curves;
  Deviations deviations;
};

/// Measures the distances between a mesh and its model.
///
/// curves  of the segments of the mesh
MeasuredMesh measured(const FaceSource& source, const MeshingOptions& options, ModelMesh mesh,
                      EdgeCurves curves);

/// Makes a mesh, and others with smaller sizes where it is farther from the model than
/// options.sizes.chords allows. Returns the best of them: with the fewest failed faces, and then
/// with the smallest distances in terms of the bounds. If a bound does not hold, a finding says so;
/// if options.sizes.minSize is the reason, a note.
MeasuredMesh meshWithinChords(MeshingOptions options,
                              const std::function<MeasuredMesh(const MeshingOptions&)>& make);

/// Removes the vertices that the bounds do not need, where elements do not cross without them.
void thinWithinChords(const FaceSource& source, const MeshingOptions& options,
                      MeasuredMesh& measured);

}  // namespace af2::geometry
