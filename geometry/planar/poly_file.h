// Triangle's .poly files: planar straight line graphs with holes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/point.h"

namespace af2::geometry {

/// A planar domain as a file gives it.
struct PlanarDomain {
  struct Segment {
    int from = 0, to = 0;  ///< indices into points
    int marker = 0;
    int line = 0;  ///< in the file
  };
  std::string name;  ///< the file
  std::vector<Point2> points;
  std::vector<int> pointLines;  ///< by point: its line in the file; may be empty
  std::vector<Segment> segments;
  std::vector<Point2> holes;  ///< one point in each region to be left out
};

/// Reads a .poly file; if it holds no vertices, those of the .node file beside it.
///
/// Throws InputError with file and line if it cannot be read.
PlanarDomain readPoly(const std::filesystem::path& path);

}  // namespace af2::geometry
