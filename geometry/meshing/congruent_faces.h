// Faces that are congruent to one that has been meshed, and take over its mesh. Not installed.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/congruence/similar_faces.h"
#include "geometry/mesh/face_mesh.h"
#include "geometry/mesh/try_limits.h"
#include "geometry/meshing/face_source.h"

namespace af2::geometry {

/// Tries at faces that may be congruent.
struct TryGroup {
  std::vector<FaceTry> tries;
  std::vector<std::size_t> meshed;  ///< a few faces with meshes that may be congruent, too
};
/// Takes the mesh of the face of a try.
using TakeMovedMesh = std::function<void(const FaceTry& at, FaceMesh)>;

class CongruentFaces {
 public:
  /// Everything is kept as a reference.
  ///
  /// faces  of the request
  CongruentFaces(const FaceSource& source, const AF2Algorithm& algorithm,
                 const MeshingOptions& options, const std::vector<int>& faces)
      : source_(source), algorithm_(algorithm), options_(options), faces_(faces) {}

  /// Each try is in one group.
  ///
  /// meshed  faces that have meshes within these edges
  std::vector<TryGroup> groupsOf(std::span<const FaceTry> tries,
                                 std::span<const std::size_t> meshed,
                                 const DividedEdges& divided) const;

  /// Moves the mesh of a face onto those of others that are congruent to it and want the same
  /// sizes, and removes these from the others. May be called from several threads at once.
  ///
  /// from, mesh  a try at the face, and what has become of it
  void move(const FaceTry& from, const FaceMesh& mesh, const PositionSize& sizes,
            const DividedEdges& divided, std::vector<FaceTry>& others,
            const TakeMovedMesh& take) const;

 private:
  void findNumbers(int face, const DividedEdges& divided, FaceNumbers& of) const;
  std::optional<FaceOutline> outlineOf(const FaceTry& at, const PositionSize& sizes,
                                       const DividedEdges& divided) const;

  const FaceSource& source_;
  const AF2Algorithm& algorithm_;
  const MeshingOptions& options_;
  const std::vector<int>& faces_;
};

/// Faces do not refer any more to congruent ones that have been meshed again since.
void forgetFormerMeshes(std::vector<FaceMesh>& meshes);

}  // namespace af2::geometry
