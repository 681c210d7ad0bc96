// Where faces come from: what the mesher asks of a model, one class for each kind of model.
// Not installed.
#pragma once

#include <string>
#include <vector>

#include "engine/run/algorithm.h"
#include "geometry/edges/divided_edges.h"
#include "geometry/fill/fill_face.h"
#include "geometry/meshing/meshing_options.h"
#include "geometry/retry/retries.h"

namespace af2::geometry {

/// What is asked of one try at a face within its divided edges.
struct FillRequest {
  const PositionSize& sizes;  ///< asked for by position: FaceSource::sizesByPosition or finer ones
  TryLimits limits;
  const DividedEdges& divided;
  const AF2Algorithm& algorithm;
  const FillOptions& options;
  bool findMiddles = false;  ///< of the sides, for elements of second order
  const ProgressCallback& progress;
};

/// Faces between edges, by ids 1, 2, ... Everything about sizes, charts and boundaries that differs
/// between kinds of models is behind this; what is done with them is not (mesh_faces.h).
///
/// What is const is called from several threads at once.
class FaceSource {
 public:
  virtual ~FaceSource() = default;

  virtual int faceCount() const = 0;
  virtual int edgeCount() const = 0;  ///< the highest id that an edge has
  virtual double diagonal() const = 0;
  /// Its id, its name and the type of its surface; once prepared, also its area.
  virtual FaceReport reportOf(int face) const = 0;
  virtual const std::vector<FaceGroup>& groups() const = 0;

  /// Comes before all that follows, and again for another run.
  ///
  /// options  kept as a reference; sizes by name are sizes by face here, and their numbers are
  ///          sound
  /// faces    to be meshed, ascending
  ///
  /// Throws InputError if the model cannot be meshed like this, e.g. with too many elements.
  virtual void prepare(const MeshingOptions& options, const std::vector<int>& faces) = 0;

  /// Elements that a face will have, about, and one more for its own sake.
  virtual double workOn(int face) const = 0;
  /// Sizes that are asked for by position, to which those of retries are added.
  virtual const PositionSize& sizesByPosition() const = 0;
  /// The edges around a face, ascending, as they are numbered in what `divide` gives.
  virtual std::vector<int> edgesOf(int face) const = 0;
  /// The id of a divided edge. One edge of the model may be divided in several parts.
  virtual int idOfEdge(int divided) const { return divided; }
  virtual Point3 pointOnEdge(int divided, double parameter) const = 0;

  /// Divides all edges, whichever faces are asked for; some of them are taken for points.
  virtual DividedEdges divide(const PositionSize& sizes, const CollapsedEdges& asPoints) const = 0;
  /// Fills a face. `mesh` has the report of the face already.
  ///
  /// Throws what keeps the face from having a mesh, which its report tells then.
  virtual void fill(int face, const FillRequest& request, FaceMesh& mesh) const = 0;

  /// The edges of a face, near some places, that may be taken for points: one choice after the
  /// other.
  virtual std::vector<CollapsedEdges> shortEdges(int, const DividedEdges&,
                                                 const std::vector<SizeSource>&) const {
    return {};
  }
  /// What is wanted inside a face where that is less than its size, if that may be too uneven for a
  /// front.
  virtual std::vector<SizeSource> sizesInside(int) const { return {}; }
  /// Whether elements that fill their faces may cross each other nevertheless.
  virtual bool mayCross() const { return true; }
  /// Of the candidates that retries may take, as charts differ in what they cost.
  virtual double retryShare() const { return 1; }

  /// Adds what the mesh of this kind of model tells besides, in its notes, findings and reports.
  /// Faces that do not pass the checks have failed already.
  virtual void complete(const MeshFaults& faults, ModelMesh& mesh) const = 0;
};

}  // namespace af2::geometry
