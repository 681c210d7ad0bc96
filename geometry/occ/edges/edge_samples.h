// An edge as a table: where its points are and which size is wanted there.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <string>
#include <vector>

#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/sizes/cad_sizes.h"

namespace af2::geometry {

/// A smooth piece of an edge, sampled finely against the sizes wanted on it.
struct EdgePiece {
  std::vector<double> parameters;
  std::vector<double> arcLength;  ///< from the start of the piece
  std::vector<Point3> positions;
  std::vector<double> sizes;
};

struct EdgeSamples {
  std::vector<EdgePiece>
      pieces;  ///< split where the curve has a kink; empty: no length or unusable
  Point3 start, end;
  double length = 0;
  double wanted = 0;    ///< the size asked for, before all limits
  std::string problem;  ///< why it is unusable
};

/// By what the faces beside the edge want, without limits by position.
EdgeSamples sampleEdge(const ModelShape& model, int edge, const CadSizes& sizes);

/// What sampleEdge gave, with the limits by position; sampled more densely where these ask for
/// small sizes. `sizes` may have another function than then, nothing else.
EdgeSamples limitedByPosition(const ModelShape& model, int edge, const CadSizes& sizes,
                              EdgeSamples samples);

/// Lets sizes grow along the edge by no more than `growth` per unit of length, from `first` and
/// `last` at its ends.
void gradeSizes(EdgeSamples& samples, double first, double last, double growth);

/// Parameters that divide the edge into pieces of the wanted sizes, ends included. The number of
/// them is the nearest; with sizes.elementsPerTurn, no piece that turns is longer than wanted.
std::vector<double> divide(const EdgeSamples& samples, std::size_t leastSegments,
                           const CadSizes& sizes);

}  // namespace af2::geometry
