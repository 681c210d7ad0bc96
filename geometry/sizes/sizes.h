// The wanted edge lengths of a mesh, as they are asked for.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"
#include "geometry/sizes/graded_size.h"
#include "geometry/sizes/position_size.h"
#include "geometry/sizes/size_sources.h"

namespace af2::geometry {

/// The largest growth of sizes per unit of length. Elements at a short segment are up to so many
/// times longer than it: the front has to look at as many segments around each of them.
constexpr double kMostGrowth = 10;

/// Wanted edge lengths, in model units. The smallest of those that apply at a place counts.
struct Sizes {
  double size = 0;  ///< everywhere; must be > 0
  /// Bounds of all wanted sizes, however they come about. Edges of the model that are shorter than
  /// `minSize` are kept nevertheless.
  double minSize = 0, maxSize = std::numeric_limits<double>::infinity();
  std::map<int, double> faceSizes;  ///< by face id; instead of `size`
  std::map<int, double> edgeSizes;  ///< by edge id; along that edge, instead of the faces' sizes
  /// By name of a face or group; `*` is any text, `?` any character. `faceSizes` count more, and of
  /// several that fit the last.
  std::vector<std::pair<std::string, double>> partSizes;
  SizeSources sources;    ///< points, boxes and background fields
  PositionSize function;  ///< further limit by position

  /// How many edges of elements go around a full turn of a curved face or edge; 0: gentle limits,
  /// which keep elements from cutting corners (about eight around a turn of a planar or faceted
  /// model; see TurnLimits for CAD models). Where a turn would need edges smaller than `minSize`,
  /// or if that is 0, than a twentieth of the size, it gets fewer.
  double elementsPerTurn = 0;

  /// How many elements lie across what is narrow: strips of faces, walls and gaps; 0: it does not
  /// matter. A first mesh shows where that is. Where it would need edges smaller than `minSize`, or
  /// if that is 0, than a twentieth of the size, there are fewer.
  double elementsAcross = 0;

  /// Most growth of the size per unit of length, away from whatever wants a small one.
  double growth = kDefaultGrowth;
};

/// Throws InputError for sizes that are not positive, or above what they should be below.
AF2_EXPORT void checkSizes(const Sizes& sizes);

/// The same sizes, but none larger than the model, as no element could be: what is small beside a
/// size is taken for nothing in places.
///
/// extent  of the model; 0: it has none, and sizes stay as they are
AF2_EXPORT Sizes withinExtent(Sizes sizes, double extent);

/// The largest of the sizes for the model, its faces and its edges.
AF2_EXPORT double largestOf(const Sizes& sizes);

/// `size`, brought between the bounds of all sizes.
AF2_EXPORT double bounded(const Sizes& sizes, double size);

/// The size for a face as the options say it, before all limits.
AF2_EXPORT double wantedOnFace(const Sizes& sizes, int face);

/// The function's limit at a position, if there is a function.
AF2_EXPORT double limitByFunction(const Sizes& sizes, double size, const Point3& position);

}  // namespace af2::geometry
