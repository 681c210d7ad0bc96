// Faces that failed, came out poor or cross each other are tried again, with one remedy after the
// other.
// Not installed.
#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "geometry/check/sound_faces.h"
#include "geometry/edges/divided_edges.h"
#include "geometry/mesh/face_mesh.h"
#include "geometry/mesh/try_limits.h"
#include "geometry/sizes/position_size.h"

namespace af2::geometry {

/// A division of the edges and the meshes made within it.
struct FaceMeshes {
  DividedEdges divided;
  std::vector<FaceMesh> meshes;  ///< by face that was asked for
  ModelMesh joined;              ///< of all of them
  MeshFaults faults;             ///< of what was joined
};

/// What trying again asks of a geometry: faces between edges that can be divided anew. Faces are
/// counted as they were asked for, from 0.
class RetriedModel {
 public:
  virtual ~RetriedModel() = default;
  /// By face: the ids of its edges in ascending order, each once.
  virtual const std::vector<std::vector<int>>& edgesOfFaces() const = 0;
  /// Divides all edges by sizes that are asked for by position, beside all others; some of them are
  /// collapsed to points.
  virtual DividedEdges divide(const PositionSize& sizes, const CollapsedEdges& collapsed) const = 0;
  /// The edges of a face, near some places, that may be collapsed to points: one choice after the
  /// other.
  virtual std::vector<CollapsedEdges> shortEdges(std::size_t i, const DividedEdges& divided,
                                                 const std::vector<SizeSource>& places) const = 0;
  /// Meshes a face within the edges of `into`. Called from several threads at once.
  virtual void mesh(std::size_t i, const PositionSize& sizes, const TryLimits& limits,
                    FaceMeshes& into) const = 0;
  /// Joins the meshes and finds their faults.
  virtual void join(FaceMeshes& state) const = 0;
  /// What is wanted inside a face where that is less than its size, if that may be too uneven for a
  /// front.
  virtual std::vector<SizeSource> sizesInside(std::size_t i) const = 0;
};

struct RetryOptions {
  PositionSize sizes;  ///< asked for by position
  double largest = 0;  ///< size that is asked for anywhere
  double growth = kDefaultGrowth;
  int threads = 0;
  std::stop_token stop;
  int mostRounds = 20;
  double share = 1;  ///< of the candidates that may be taken
};

/// Where faces failed, came out poor or cross each other, tries the remedies of the table
/// (remedies.cpp), as long as that brings something and costs no more than some times the mesh
/// itself. Faces beside edges that are divided anew are meshed anew. Leaves the best state by its
/// score (score.h), joined, with the history of each face in its report.
void retryPoorFaces(const RetriedModel& model, const RetryOptions& options, FaceMeshes& state);

}  // namespace af2::geometry
