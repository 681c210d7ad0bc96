// The wanted edge lengths of a mesh, as the user requests them.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"
#include "geometry/sizes/chord.h"
#include "geometry/sizes/graded_size.h"
#include "geometry/sizes/position_size.h"
#include "geometry/sizes/size_sources.h"

namespace af2::geometry {

/// The largest allowed growth of sizes per unit of length. Elements at a short segment are up to
/// this many times longer than the segment, and the front has to examine as many segments around
/// each of them.
constexpr double kMaxGrowth = 10;

/// Wanted edge lengths, in model units. The smallest size that applies at a place counts.
struct Sizes {
  double size = 0;  ///< everywhere; must be > 0
  /// Bounds of all wanted sizes, from any source. Edges of the model that are shorter than
  /// `minSize` are kept nevertheless, and tubes of CAD models have at least four elements around.
  double minSize = 0, maxSize = std::numeric_limits<double>::infinity();
  std::map<int, double> faceSizes;  ///< by face id; instead of `size`
  std::map<int, double> edgeSizes;  ///< by edge id; along that edge, instead of the faces' sizes
  /// By name of a face or group; `*` matches any text, `?` any character. `faceSizes` take
  /// precedence, and of several matches the last.
  std::vector<std::pair<std::string, double>> partSizes;
  /// By name of a boundary, or of a face or group for the edges that its faces use once, with the
  /// same patterns. `edgeSizes` take precedence, and of several matches the last.
  std::vector<std::pair<std::string, double>> edgeNames = {};
  SizeSources sources;    ///< points, boxes and background fields
  PositionSize function;  ///< further limit by position

  /// The number of element edges around a full turn of a curved face or edge; 0: weak limits, which
  /// keep elements from cutting corners (about eight around a turn of a planar or faceted model;
  /// see TurnLimits for CAD models). A turn gets fewer edges if these would be smaller than
  /// `minSize`, or, if that is 0, than a twentieth of the size.
  double elementsPerTurn = 0;

  /// The number of elements across narrow places: strips of faces, walls and gaps; 0: no
  /// requirement. A first mesh finds these places. There are fewer elements where their edges would
  /// be smaller than `minSize`, or, if that is 0, than a twentieth of the size.
  double elementsAcross = 0;

  /// Bounds on the distance between mesh and model. Sizes on curved faces and edges are chosen so
  /// that they hold, but are never below `minSize`; the mesh is measured, and made again with
  /// smaller sizes where it is too far away.
  ChordBounds chords;

  /// Largest growth of the size per unit of length, away from places with small sizes.
  double growth = kDefaultGrowth;
};

/// Throws InputError for sizes that are not positive, or that exceed their upper bound.
AF2_EXPORT void checkSizes(const Sizes& sizes);

/// The same sizes, but none larger than the model. No element can be larger, and some tolerances
/// are relative to the size, so that too large a size would swallow details.
///
/// extent  of the model; 0: it has none, and sizes stay as they are
AF2_EXPORT Sizes withinExtent(Sizes sizes, double extent);

/// The largest of the sizes for the model, its faces and its edges.
AF2_EXPORT double largestOf(const Sizes& sizes);

/// The note for a size below the smallest one.
AF2_EXPORT std::string raisedSizeNote(const Sizes& sizes);

/// `size`, brought between the bounds of all sizes.
AF2_EXPORT double bounded(const Sizes& sizes, double size);

/// The size of a face in the options, before all limits.
AF2_EXPORT double wantedOnFace(const Sizes& sizes, int face);

/// The bound on the distance between the mesh and a face, in model units; infinite: none.
AF2_EXPORT double chordOnFace(const Sizes& sizes, int face);

/// The function's limit at a position, if there is a function.
AF2_EXPORT double limitByFunction(const Sizes& sizes, double size, const Point3& position);

}  // namespace af2::geometry
