// Splits edges into parts at the vertices of other edges that they pass.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/edges/given_points.h"
#include "geometry/occ/edges/open_ends.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

struct EdgeEnd {
  std::size_t edge = 0;  ///< [0] is edge 1
  bool isStart = true;
  auto operator<=>(const EdgeEnd&) const = default;
};

/// The ends of the edges of a face, grouped by point, without edges that are points.
///
/// ends, samples  by edge; [0] is edge 1
std::map<std::uint32_t, std::vector<EdgeEnd>> endsByPoint(const std::vector<EdgeUse>& edgesOfFace,
                                                          const std::vector<Ends>& ends,
                                                          const std::vector<EdgeSamples>& samples);

/// The direction in which an edge leaves one of its ends, of unit length. It must not be a point.
Point3 directionFrom(EdgeEnd end, const std::vector<EdgeSamples>& samples);

/// The part of an edge between two of the points that it passes, or the whole edge.
struct EdgePart {
  std::size_t edge = 0;  ///< [0] is edge 1
  EdgeSamples samples;
  Ends ends;
  /// Whether the part begins and ends where the edge does, rather than where the edge passes the
  /// end of another one.
  bool isFirst = true, isLast = true;
  /// Whether it is a chain of edges, named by the first of them.
  bool isChain = false;

  EdgeRange range() const {
    return {samples.pieces.front().parameters.front(), samples.pieces.back().parameters.back(),
            samples.length, 0};
  }
};

/// The samples of the parts between these parameters, which are in order between the ends.
std::vector<EdgeSamples> split(EdgeSamples samples, const std::vector<double>& parameters);

/// The diagonal of the box around an edge; 0 if it has no length or is unusable.
double extentOf(const EdgeSamples& samples);

/// The parameter at a length from the start; the length is between 0 and that of the edge.
double parameterAt(const EdgeSamples& samples, double length);

}  // namespace af2::geometry
