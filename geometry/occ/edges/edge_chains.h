// Edges that the mesh does not follow, and chains of edges that it follows as if each were one
// edge. Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <cstddef>
#include <functional>
#include <vector>

#include "engine/base/point.h"
#include "geometry/occ/edges/edge_parts.h"
#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/edges/merged_edges.h"
#include "geometry/occ/edges/open_ends.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// A chain as one curve. Its parameter runs from 0 through the parameters of one edge after the
/// other. For the calling thread alone.
class ChainCurve {
 public:
  ChainCurve(const ModelShape& model, const EdgeChain& chain);
  Point3 at(double parameter) const;
  /// The parameter of a link at that of its edge.
  double parameterOf(std::size_t link, double ofEdge) const;

 private:
  struct Part {
    BRepAdaptor_Curve curve;
    bool isReversed;
    double start;  // parameter of the chain
  };
  std::vector<Part> parts_;
};

/// A chain as a part of its first edge.
///
/// ends  by edge; [0] is edge 1
EdgePart chainPart(const EdgeChain& chain, EdgeSamples samples, const std::vector<Ends>& ends);

/// The curve of a part of an edge, or of a chain. For the calling thread alone.
using PointAt = std::function<Point3(double parameter)>;
PointAt curveOf(const ModelShape& model, const EdgePart& part, const MergedEdges& merged);

/// The samples of a chain, from those of its edges: one piece, except where an edge has a kink.
EdgeSamples chainedSamples(const ModelShape& model, const EdgeChain& chain,
                           const std::vector<EdgeSamples>& samples);

}  // namespace af2::geometry
