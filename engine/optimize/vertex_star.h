// Walks around one vertex of a mesh.
#pragma once

#include "engine/mesh/mesh_topology.h"

namespace af2 {

/// Calls visit(Corner) for the corner of the vertex in each element around it, counter-clockwise.
template <class Visit>
void forEachCornerAt(const MeshTopology& topology, VertexId v, const Visit& visit) {
  const Corner first = topology.cornerOf(v);
  for (Corner c = first; !c.isNone();) {
    visit(c);
    c = topology.aroundVertex(c);
    if (c == first) break;
  }
}

/// Calls visit(VertexId) for the other end of each side at the vertex.
template <class Visit>
void forEachNeighborOf(const MeshTopology& topology, VertexId v, const Visit& visit) {
  Corner last;
  forEachCornerAt(topology, v, [&](Corner c) {
    visit(topology.vertexAt(topology.next(c)));
    last = c;
  });
  if (!last.isNone() && topology.aroundVertex(last).isNone())
    visit(topology.vertexAt(topology.previous(last)));
}

}  // namespace af2
