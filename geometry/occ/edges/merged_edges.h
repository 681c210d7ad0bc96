// Edges that the mesh does not follow, and edges that it follows as one.
// Not installed.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

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

}  // namespace af2::geometry
