// Edges that the mesh does not follow, and chains of edges that it follows as if each were one
// edge. Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <cstddef>
#include <set>
#include <vector>

#include "engine/base/point.h"
#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// An edge of a chain, in the direction of the chain.
struct ChainLink {
  int edge = 0;
  bool isReversed = false;
};

/// At least two edges, each of which begins where the one before ends. The division of the whole
/// chain is that of its first edge; the others have none.
struct EdgeChain {
  std::vector<ChainLink> links;
  int id() const { return links.front().edge; }
};

struct MergedEdges {
  std::vector<bool> isRemoved;  ///< by edge, [0] is edge 1; those beyond its end are not removed
  std::vector<EdgeChain> chains;
  std::set<int> narrowFaces;  ///< that are part of wider ones: their width limits no sizes

  bool isEmpty() const { return isRemoved.empty() && chains.empty(); }
  bool removes(std::size_t index) const { return index < isRemoved.size() && isRemoved[index]; }
};

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

/// The samples of a chain, from those of its edges: one piece, except where an edge has a kink.
EdgeSamples chainedSamples(const ModelShape& model, const EdgeChain& chain,
                           const std::vector<EdgeSamples>& samples);

}  // namespace af2::geometry
