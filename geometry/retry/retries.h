// Retries faces that failed, came out poor or cross each other, with one remedy after the other.
// Not installed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

#include "geometry/check/sound_faces.h"
#include "geometry/edges/divided_edges.h"
#include "geometry/mesh/face_mesh.h"
#include "geometry/mesh/try_limits.h"
#include "geometry/retry/refinement.h"
#include "geometry/sizes/position_size.h"

namespace af2::geometry {

/// A division of the edges and the meshes made within it.
struct FaceMeshes {
  DividedEdges divided;
  std::vector<FaceMesh> meshes;  ///< by requested face
  ModelMesh joined;              ///< of all of them
  MeshFaults faults;             ///< of the joined mesh
  /// By requested face: it has not been meshed within this division yet. Empty: all have been.
  std::vector<bool> isWaiting = {};

  bool waits(std::size_t i) const { return !isWaiting.empty() && isWaiting[i]; }
  bool isComplete() const { return std::ranges::count(isWaiting, true) == 0; }
};

/// The interface of a model to the retries: faces between edges that can be divided again. Faces
/// are counted in the order of the request, from 0.
class RetriedModel {
 public:
  virtual ~RetriedModel() = default;
  /// By face: the ids of its edges in ascending order, each once.
  virtual const std::vector<std::vector<int>>& edgesOfFaces() const = 0;
  /// Divides all edges by sizes by position, in addition to all other sizes; some edges are
  /// collapsed to points.
  virtual DividedEdges divide(const PositionSize& sizes, const CollapsedEdges& collapsed) const = 0;
  /// Edges of a face, near some places, that may be collapsed to points: alternatives, in the order
  /// in which to try them.
  virtual std::vector<CollapsedEdges> shortEdges(std::size_t i, const DividedEdges& divided,
                                                 const std::vector<SizeSource>& places) const = 0;
  /// Meshes a face within the edges of `into`. Called from several threads at once.
  virtual void mesh(std::size_t i, const PositionSize& sizes, const TryLimits& limits,
                    FaceMeshes& into) const = 0;
  /// Meshes faces as `mesh` does, several at the same time.
  virtual void meshAll(std::span<const FaceTry> tries, const RequestedSizes& sizes, int threads,
                       FaceMeshes& into) const;
  /// Joins the meshes and finds their faults.
  virtual void join(FaceMeshes& state) const = 0;
  /// The sizes wanted inside a face where they are below its general size, if they may be too
  /// uneven for a front.
  virtual std::vector<SizeSource> sizesInside(std::size_t i) const = 0;
  /// Whether a face has a fault in the model itself that no division of its edges can mend.
  virtual bool hasFaultInModel(std::size_t) const { return false; }
  /// Whether a face meets others in the model itself, where its elements cross theirs.
  virtual bool meetsOthers(std::size_t, const std::vector<Crossing>&) const { return false; }
};

struct RetryOptions {
  PositionSize sizes;  ///< requested by position
  double largest = 0;  ///< largest requested size
  double growth = kDefaultGrowth;
  int threads = 0;
  std::stop_token stop;
  int mostRounds = 20;
  double share = 1;     ///< factor for the budget of candidates
  bool mayTilt = true;  ///< as the last remedy, elements may tilt against the surface by any angle
  /// Whether the rules may make quadrilaterals with a reflex corner, to be turned round later.
  bool mayMakeReflex = false;
};

/// Where faces failed, came out poor or cross each other, tries the remedies of the table
/// (remedies.cpp), as long as they bring progress and the cost stays below a multiple of that of
/// the mesh. Faces at edges that were divided again are meshed again, once the faces that asked for
/// it are content or given up. Faces may wait for their first mesh, too. The result in `state` is
/// the best state by its score (score.h), complete and joined, with the history of each face in its
/// report.
void retryPoorFaces(const RetriedModel& model, const RetryOptions& options, FaceMeshes& state);

}  // namespace af2::geometry
