// Several processes that mesh the faces of a model together: one leads, the others follow.
// Not installed.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "engine/run/mesh_region.h"
#include "geometry/edges/divided_edges.h"
#include "geometry/mesh/face_mesh.h"
#include "geometry/mesh/try_limits.h"
#include "geometry/meshing/meshing_options.h"

namespace af2::geometry {

/// What the tries of a round have in common.
struct FaceRound {
  const DividedEdges& divided;
  /// Near these, remedies ask for smaller sizes than the user does.
  std::vector<SizeSource> near;
};

/// What a run over the faces may ask for instead of the options that all processes know.
struct RunChange {
  std::vector<int> faces;
  std::map<int, double> faceSizes;
  SizeSources sources;
  ChordBounds chords;
  bool optimize = true, evenLoops = false, hasLayers = true;
  int order = 1;
  SpoolRequest::When keepFaces = SpoolRequest::When::Never;
  SpoolRequest::Where keptIn = SpoolRequest::Where::Disk;
};

RunChange changeOf(const MeshingOptions& options);
/// The options of a run, from those that all processes know.
MeshingOptions withChange(MeshingOptions options, const RunChange& change);

/// Meshes a face within the edges of a round. Called from several threads at once.
///
/// pieces  who else meshes pieces of the face, if it is cut; may be null
using MeshTry = std::function<FaceMesh(const FaceTry&, RegionCrew* pieces)>;
/// Takes the mesh of the k-th try. Called from several threads, also at once.
using TakeMesh = std::function<void(std::size_t k, FaceMesh)>;

/// Puts away the bulk of a face, if faces are kept where they are meshed. Called from several
/// threads at once.
using KeepMesh = std::function<void(FaceMesh&)>;

/// The process that divides the edges, decides which faces are meshed and tried again, and joins
/// their meshes.
class CrewLeader {
 public:
  virtual ~CrewLeader() = default;
  virtual void beginRun(const RunChange& change) = 0;
  /// A round: returns when `take` has got the meshes of all tries.
  ///
  /// work  by try: the approximate number of elements. The most work is begun first.
  virtual void meshAll(const FaceRound& round, std::span<const FaceTry> tries,
                       std::span<const double> work, const MeshTry& mesh, const TakeMesh& take) = 0;
  virtual void endRun() = 0;
  /// Tells the others what has become of the faces, so that they take the same decisions.
  virtual void endModel(const ModelMesh& mesh) = 0;
};

/// A process that only meshes faces, to the same bits as any other process.
class CrewFollower {
 public:
  virtual ~CrewFollower() = default;
  /// None: the model is meshed.
  virtual std::optional<RunChange> nextRun() = 0;
  /// None: the run is over. The edges live until the next call.
  virtual std::optional<FaceRound> nextRound() = 0;
  /// Meshes faces until the round is over.
  ///
  /// keep  called with each face that this process has finished: what it puts away stays there, and
  ///       the leader gets it when it asks for it
  virtual void help(const MeshTry& mesh, const KeepMesh& keep) = 0;
  /// The mesh without vertices and elements.
  virtual ModelMesh reports() = 0;
};

/// All processes call `meshFaces` with the same model and options, and each prepares the same runs
/// over the faces. In each round of a run, whoever is free meshes the next face.
class FaceCrew {
 public:
  virtual ~FaceCrew() = default;
  virtual CrewLeader* leader() = 0;      ///< null: this process follows, or is alone
  virtual CrewFollower* follower() = 0;  ///< null: this process leads, or is alone
};

}  // namespace af2::geometry
