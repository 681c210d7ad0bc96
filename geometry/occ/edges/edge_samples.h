// Samples of an edge: positions and the sizes wanted there.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <string>
#include <vector>

#include "geometry/base/shared_array.h"
#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/sizes/cad_sizes.h"

namespace af2::geometry {

/// A smooth piece of an edge, sampled finely compared with the sizes wanted on it.
/// Pieces are copied for each division of a model, which only changes their sizes.
struct EdgePiece {
  SharedArray<double> parameters;
  SharedArray<double> arcLength;  ///< from the start of the piece
  SharedArray<Point3> positions;
  std::vector<double> sizes;
  SharedArray<double> least;  ///< lower bounds of the sizes
};

struct EdgeSamples {
  std::vector<EdgePiece>
      pieces;  ///< split where the curve has a kink; empty: no length or unusable
  Point3 start, end;
  double length = 0;
  double wanted = 0;    ///< the requested size, before all limits
  std::string problem;  ///< why it is unusable
};

/// Samples an edge with the sizes that its faces want, without limits by position.
EdgeSamples sampleEdge(const ModelShape& model, int edge, const CadSizes& sizes);

/// Adds the limits by position to the result of sampleEdge, and samples more densely where these
/// require small sizes. `sizes` may differ from those given to sampleEdge only in the function.
EdgeSamples limitedByPosition(const ModelShape& model, int edge, const CadSizes& sizes,
                              EdgeSamples samples);

/// Whether a function would leave samples as they are.
///
/// areDense  they have had limits by position already, and are as dense as these ask for
bool isWithinLimits(const PositionSize& function, const CadSizes& sizes, const EdgeSamples& samples,
                    bool areDense);

/// Limits the growth of sizes along the edge to `growth` per unit of length, from `first` and
/// `last` at its ends.
void gradeSizes(EdgeSamples& samples, double first, double last, double growth);

}  // namespace af2::geometry
