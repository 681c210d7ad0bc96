// The options for meshing a model: a planar domain, a surface of triangles or a CAD model.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/optimize/optimize.h"
#include "engine/run/algorithm.h"
#include "geometry/charts/chart_kind.h"
#include "geometry/edges/edge_points.h"
#include "geometry/layers/layer_request.h"
#include "geometry/sizes/sizes.h"

namespace af2::geometry {

class FaceCrew;

/// The progress of meshing a model. Work is counted in expected elements.
struct ModelProgress {
  double workDone = 0, workTotal = 0;
  int facesDone = 0, faces = 0;
  std::size_t elements = 0;
};

/// Whether the vertices inside faces and the elements of a mesh are put away, face by face, when
/// these are done. The mesh has the same bits, and takes little more memory than the largest of its
/// faces while they are meshed. Not for elements of second order, bounds on the distance from the
/// model, elements across narrow places, and merged or periodic faces.
struct SpoolRequest {
  enum class When {
    Never,
    IfNeeded,  ///< if the mesh needs more memory than there is, but its faces one by one do not
    Always,
  };
  enum class Where {
    Disk,
    Memory,  ///< packed, in a fifth of what they take otherwise; with a crew, of who has meshed
             ///< them
  };
  When when = When::Never;
  std::filesystem::path folder = {};  ///< for a file without a name; empty: the current one
  Where where = Where::Disk;
};

struct MeshingOptions {
  Sizes sizes;
  /// Given divisions of edges, by id: the vertices between the ends, in order along the edge in
  /// either direction; none: the edge is a single segment. They are kept unchanged.
  EdgePoints edgePoints;
  /// Layers of quadrilaterals along edges. The rest of each face is filled by the rules. Where
  /// requests name the same edge of a face, the last one counts. FaceReport::layers says where
  /// there was room for fewer layers.
  std::vector<LayerRequest> layers = {};
  /// The kind of charts. A face whose surface has no such charts, or on which they fail, is meshed
  /// as with ChartKind::Auto; its report says so.
  ChartKind chart = ChartKind::Auto;
  /// Every boundary loop of every face gets an even number of segments where possible, because an
  /// odd loop cannot be filled with quadrilaterals alone. For this, edges get one segment more or
  /// fewer than their sizes ask for; given divisions, kept boundaries, least numbers of segments
  /// and limits of turns still hold. A loop that cannot be made even stays odd:
  /// FaceReport::oddLoops.
  bool evenLoops = false;
  int order = 1;  ///< 2: elements with vertices at the middles of their sides as well
  /// As few triangles as the bounds on the distance from the model allow: vertices that are not
  /// needed are removed from the mesh. Needs Sizes::chords, and elements of first order.
  bool fewest = false;
  std::vector<int> faces;  ///< ids of the faces to mesh; empty, and no names: all
  /// Names of faces and groups to mesh, too, as in Sizes::partSizes.
  std::vector<std::string> faceNames = {};
  /// Bytes for the mesh. Sizes that need more are refused before meshing begins. 0: what is free.
  double maxMemory = 0;
  /// Larger sizes where those that are asked for need more memory: ModelMesh::notes says how much
  /// larger.
  bool coarsen = false;
  SpoolRequest spool = {};  ///< the result is then ModelMesh::spooled
  int threads = 0;          ///< 0: as many as the machine has. The mesh does not depend on it.
  /// Called from several threads, one at a time.
  std::function<void(const ModelProgress&)> progress;
  bool optimize = true;  ///< swaps and smoothing after the front has closed; false: the raw front
  QuadCleanUp quads;     ///< how thoroughly quadrilaterals are cleaned up, if `optimize`
  /// A face fails where the rules do not fill it: at the first stuck front, without other charts,
  /// without elements that no rule makes, and without further tries.
  bool strictRules = false;
  /// Maximum number of rounds in which faces that failed or came out poor are retried; empty: as
  /// many as usually help. With fewer than two, finer sizes are not tried, either.
  std::optional<int> mostRetries;
  std::stop_token stop;
  /// The observer of one face, or null; called on the thread that meshes the face.
  std::function<AF2MeshingObserver*(int face)> observer;
  /// Other processes that mesh faces of the same model, as af2-mpi has; null: none.
  FaceCrew* crew = nullptr;

  /// Planar domains: each segment of the domain is one edge of the mesh, of any length.
  bool keepBoundary = false;
  /// Surfaces of triangles: edges at which the surface turns by more than this angle, in degrees,
  /// are kept.
  double featureAngle = 40;
};

}  // namespace af2::geometry
