// The interface of a model to the mesher, with one implementation for each kind of model.
// Not installed.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/run/algorithm.h"
#include "geometry/congruence/face_outline.h"
#include "geometry/deviation/face_distance.h"
#include "geometry/edges/divided_edges.h"
#include "geometry/edges/even_loops.h"
#include "geometry/fill/fill_face.h"
#include "geometry/meshing/meshing_options.h"
#include "geometry/retry/retries.h"

namespace af2::geometry {

/// Without an observer or a crew.
inline FillOptions fillOptionsOf(const MeshingOptions& options) {
  return {options.chart, options.optimize, options.quads, options.strictRules, options.stop, {},
          nullptr};
}

/// The input of one try at a face within its divided edges.
struct FillRequest {
  const PositionSize& sizes;  ///< by position: FaceSource::sizesByPosition or smaller ones
  TryLimits limits;
  const DividedEdges& divided;
  const AF2Algorithm& algorithm;
  const FillOptions& options;
  bool findMiddles = false;  ///< of the sides, for elements of second order
  const ProgressCallback& progress;
};

/// Faces between edges, by ids 1, 2, ... It hides everything about sizes, charts and boundaries
/// that differs between kinds of models; the steps of meshing are common to all (mesh_faces.h).
///
/// The const functions are called from several threads at once.
class FaceSource {
 public:
  virtual ~FaceSource() = default;

  virtual int faceCount() const = 0;
  virtual int edgeCount() const = 0;  ///< the highest id that an edge has
  virtual double diagonal() const = 0;
  /// The id of a face, its name and the type of its surface; after `prepare` also its area.
  virtual FaceReport reportOf(int face) const = 0;
  virtual const std::vector<FaceGroup>& groups() const = 0;
  virtual const std::vector<EdgeGroup>& boundaries() const {
    static const std::vector<EdgeGroup> kNone;
    return kNone;
  }
  /// The ids of the edges around a face, ascending; each as often as the face uses it.
  virtual std::vector<int> edgeIdsOf(int) const { return {}; }

  /// Called before all functions below, and again for another run.
  ///
  /// options  kept as a reference; checked, with sizes by face instead of sizes by name
  /// faces    to be meshed, ascending
  ///
  /// Throws InputError if the model cannot be meshed with these options, e.g. with too many
  /// elements.
  virtual void prepare(const MeshingOptions& options, const std::vector<int>& faces) = 0;

  /// The approximate number of elements of a face, plus one for the work per face.
  virtual double workOn(int face) const = 0;
  /// The sizes by position, to which those of retries are added.
  virtual const PositionSize& sizesByPosition() const = 0;
  /// The edges around a face, ascending, with the numbers that `divide` uses.
  virtual std::vector<int> edgesOf(int face) const = 0;
  /// The id of a divided edge. One edge of the model may be divided in several parts.
  virtual int idOfEdge(int divided) const { return divided; }
  virtual Point3 pointOnEdge(int divided, double parameter) const = 0;
  /// Measures how far points are from the surface of a face; for one thread. Null: elements with
  /// their corners on it lie in it.
  virtual std::unique_ptr<FaceDistance> distanceFrom(int) const { return nullptr; }

  /// Divides all edges, whichever faces are requested; some of them are collapsed to points.
  ///
  /// changes  by count of the division without changes. Where a change is not possible, the number
  ///          of segments stays as it is.
  virtual DividedEdges divide(const PositionSize& sizes, const CollapsedEdges& asPoints,
                              const SegmentChanges& changes) const = 0;
  /// The loops around a face as its front gets them; none if it will have no front.
  ///
  /// Throws an exception if the boundary of the face is faulty.
  virtual std::vector<CountedLoop> loopsOf(int face, const DividedEdges& divided) const = 0;
  /// Fills a face. `mesh` has the report of the face already.
  ///
  /// Throws an exception if the face cannot be meshed; its message goes to the report.
  virtual void fill(int face, const FillRequest& request, FaceMesh& mesh) const = 0;
  /// Whether `outlineOf` may give anything.
  virtual bool hasOutlines() const { return false; }
  /// What `fill` would fill, to be compared with other faces. None if the mesh of the face cannot
  /// be that of another one.
  virtual std::optional<FaceOutline> outlineOf(int, const FillRequest&) const { return {}; }

  /// Edges of a face, near some places, that may be collapsed to points: alternatives, in the order
  /// in which to try them.
  virtual std::vector<CollapsedEdges> shortEdges(int, const DividedEdges&,
                                                 const std::vector<SizeSource>&) const {
    return {};
  }
  /// The sizes wanted inside a face where they are below its general size, if they may be too
  /// uneven for a front.
  virtual std::vector<SizeSource> sizesInside(int) const { return {}; }
  /// Whether a face has a fault in the model itself that no division of its edges can mend.
  virtual bool hasFaultInModel(int) const { return false; }
  /// Whether a face meets others in the model itself, where its elements cross theirs.
  virtual bool meetsOthers(int, const std::vector<Crossing>&) const { return false; }
  /// Whether elements may cross even though each face is filled correctly.
  virtual bool mayCross() const { return true; }
  /// Factor for the candidates that retries may use, because charts differ in their cost.
  virtual double retryShare() const { return 1; }
  /// Whether the elements of faces that have failed may tilt against the surface by any angle.
  virtual bool mayTilt() const { return true; }

  /// Adds what is specific to this kind of model to the notes, findings and reports of the mesh.
  /// Faces that do not pass the checks have failed already.
  virtual void complete(const MeshFaults& faults, ModelMesh& mesh) const = 0;
};

}  // namespace af2::geometry
