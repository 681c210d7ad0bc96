// Triangle's .poly files: planar straight line graphs with holes.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2::geometry {

/// A planar domain, as read from a file.
struct PlanarDomain {
  static constexpr int kAnyDomain = -1;
  struct Segment {
    int from = 0, to = 0;  ///< indices into points
    int marker = 0;        ///< of its boundary; 0: none
    int line = 0;          ///< in the file
    int edge = 0;          ///< to which it belongs: 1, 2, ...
    /// Numbers of the domains on its two sides; 0: outside, kAnyDomain: not given.
    int left = kAnyDomain, right = kAnyDomain;
    /// Parameters of its ends on the edge, if that is curved.
    double fromParameter = 0, toParameter = 1;
    double maxSize = std::numeric_limits<double>::infinity();
  };
  /// A curved edge: its points by parameter. Its segments are consecutive.
  using Curve = std::function<Point2(double)>;
  std::string name;  ///< the file
  std::vector<Point2> points;
  bool keepsPoints = true;      ///< points that no segment uses are also vertices of the mesh
  std::vector<int> pointLines;  ///< by point: its line in the file; may be empty
  std::vector<Segment> segments;
  std::map<int, Curve> curves;             ///< by edge; the others are straight
  std::map<int, std::string> domainNames;  ///< by number
  std::map<int, double> domainSizes;       ///< by number: a size of its own
  std::map<int, std::string> markerNames;  ///< by marker, if the file gives it a name
  std::vector<Point2> holes;               ///< one point in each region to be excluded
  /// A point in a region, and the number of its domain.
  struct RegionPoint {
    Point2 inside;
    int domain = 0;
  };
  std::vector<RegionPoint> regionPoints;
};

/// Reads a .poly file; if it contains no vertices, they are read from the .node file next to it.
///
/// Throws InputError with file and line if it cannot be read.
AF2_EXPORT PlanarDomain readPoly(const std::filesystem::path& path);

}  // namespace af2::geometry
