// What is wanted of the mesh of a CAD model.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <set>
#include <stop_token>
#include <vector>

#include "engine/run/algorithm.h"
#include "geometry/charts/chart_kind.h"
#include "geometry/edges/edge_points.h"
#include "geometry/sizes/position_size.h"
#include "geometry/sizes/size_sources.h"

namespace af2::geometry {

/// Wanted edge lengths, in model units. The smallest of those that apply at a place counts.
struct ModelSizes {
  double size = 0;  ///< everywhere; must be > 0
  /// Bounds of all wanted sizes, however they come about. Edges of the model that are shorter than
  /// `minSize` are kept nevertheless.
  double minSize = 0, maxSize = std::numeric_limits<double>::infinity();
  std::map<int, double> faceSizes;  ///< by face id; instead of `size`
  std::map<int, double> edgeSizes;  ///< by edge id; along that edge, instead of the faces' sizes
  SizeSources sources;              ///< points, boxes and background fields
  PositionSize function;            ///< further limit by position

  /// How many edges of elements go around a full turn of a curved face or edge; 0: the gentle
  /// limits below. Where a turn would need edges smaller than `minSize`, or if that is 0, than a
  /// twentieth of the size, it gets fewer.
  double elementsPerTurn = 0;

  /// How many elements lie across what is narrow: strips of faces, walls and gaps; 0: it does not
  /// matter. A first mesh shows where that is. Where it would need edges smaller than `minSize`, or
  /// if that is 0, than a twentieth of the size, there are fewer.
  double elementsAcross = 0;

  /// Where an edge turns quickly it needs shorter segments: one segment turns by at most `edgeTurn`
  /// radians, unless it would be shorter than `edgeLeast` times the wanted length.
  double edgeTurn = 0.7854, edgeLeast = 0.1;
  /// Likewise on faces, and on edges next to them: an edge of an element turns by about `faceTurn`
  /// radians around the smaller radius of curvature. The default puts three rows of triangles
  /// across the rounding of a right angle: with two and a half, their vertices would not fit in.
  /// `bentFaceLeast` is for tubes, which turn by more than about a right angle: elements across the
  /// whole of them would cut off too much.
  double faceTurn = 0.6046, faceLeast = 0.35, bentFaceLeast = 0.1;
  /// Faces that are rough rather than bent: there `bentFaceLeast` does not count. Those on which
  /// sizes by curvature change faster than they could be sampled are added.
  std::set<int> roughFaces;
  /// What elements on curved faces and their edges aim at, as a share of the size that is wanted
  /// there. With `elementsPerTurn` it is 0.9: lengths scatter by a tenth, and hardly an edge is to
  /// be longer than wanted.
  double curvedShare = 1;
  /// Most growth of the size per unit of length, away from whatever wants a small one.
  double growth = kDefaultGrowth;
};

/// How far the meshing of a model has come. Work is counted in expected elements.
struct ModelProgress {
  double workDone = 0, workTotal = 0;
  int facesDone = 0, faces = 0;
  std::size_t elements = 0;
};

struct ModelMeshingOptions {
  ModelSizes sizes;
  /// Edges that are divided already, by id: the vertices between their ends, in order along the
  /// edge, one way or the other; none: the edge is a single segment. They are kept as they are.
  EdgePoints edgePoints;
  /// How surfaces are seen. A face whose surface has no such charts, or on which they fail, is
  /// meshed as with ChartKind::Auto; its report tells.
  ChartKind chart = ChartKind::Auto;
  int order = 1;           ///< 2: elements with vertices at the middles of their sides as well
  std::vector<int> faces;  ///< ids of the faces to mesh; empty: all
  int threads = 0;         ///< 0: as many as the machine has. The mesh does not depend on it.
  /// Called from several threads, one at a time.
  std::function<void(const ModelProgress&)> progress;
  bool optimize = true;  ///< swaps and smoothing after the front has closed; false: the raw front
  std::stop_token stop;
  /// The observer of one face, or null; asked for from the thread that meshes the face.
  std::function<AF2MeshingObserver*(int face)> observer;
};

}  // namespace af2::geometry
