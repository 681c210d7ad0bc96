// Joins the odd nodes of a graph by paths of small total weight.
// Not installed.
#pragma once

#include <cstddef>
#include <vector>

namespace af2::geometry {

/// An edge of a graph, between two different nodes.
struct NodeLink {
  std::size_t from = 0, to = 0;
  double weight = 0;  ///< > 0
};

/// Chooses links so that every odd node has an odd number of chosen links, and every other node an
/// even number, except the free node, which may have any.
///
/// The choice begins with the only one within the spanning forest of least weight. It is then
/// improved by exchanges along cycles, each made of a link and its path in a spanning forest that
/// prefers chosen links, until no such cycle lowers the weight. The weight of the result is the
/// least or close to it.
///
/// Each connected part without the free node must have an even number of odd nodes.
///
/// Returns whether each link is chosen. Ties go to the link with the lower index.
std::vector<bool> joinOddNodes(std::vector<bool> isOdd, std::size_t freeNode,
                               const std::vector<NodeLink>& links);

}  // namespace af2::geometry
