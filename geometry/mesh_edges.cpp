#include "geometry/mesh_edges.h"

#include <algorithm>

namespace af2::geometry {
namespace {

/// One side of an element, filed under its lower vertex.
struct Side {
  std::uint32_t to;
  std::int32_t face;
};

/// Sides in groups by lower vertex: those of vertex v are sides[first[v]] to sides[first[v + 1] -
/// 1], in the order of the elements.
struct SidesByVertex {
  std::vector<std::uint32_t> first;
  std::vector<Side> sides;
};

template <class Visit>
void forEachSide(const ModelMesh& mesh, Visit visit) {
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    const auto corners = mesh.elements[i].vertices();
    std::uint32_t last = corners.back().value;
    for (const VertexId corner : corners) {
      visit(std::min(last, corner.value), Side{std::max(last, corner.value), mesh.face[i]});
      last = corner.value;
    }
  }
}

SidesByVertex groupSides(const ModelMesh& mesh) {
  SidesByVertex groups;
  groups.first.assign(mesh.vertices.size() + 2, 0);
  forEachSide(mesh, [&](std::uint32_t from, Side) { ++groups.first[from + 2]; });
  for (std::size_t v = 2; v < groups.first.size(); ++v) groups.first[v] += groups.first[v - 1];
  groups.sides.resize(groups.first.back());
  // first[v + 1] is where the next side of v goes; when all are placed, that is its end.
  forEachSide(
      mesh, [&](std::uint32_t from, Side side) { groups.sides[groups.first[from + 1]++] = side; });
  return groups;
}

void markModelEdges(const ModelMesh& mesh, std::vector<MeshEdge>& edges) {
  for (const EdgeSegment& segment : mesh.segments) {
    const auto [from, to] = std::minmax(segment.from, segment.to);
    const auto edge = std::ranges::lower_bound(
        edges, std::pair(from, to), {}, [](const MeshEdge& e) { return std::pair(e.from, e.to); });
    if (edge != edges.end() && edge->from == from && edge->to == to) edge->modelEdge = segment.edge;
  }
}

}  // namespace

std::vector<MeshEdge> meshEdges(const ModelMesh& mesh) {
  SidesByVertex groups = groupSides(mesh);
  std::vector<MeshEdge> edges;
  edges.reserve(groups.sides.size() / 2 + mesh.segments.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const std::span group(groups.sides.data() + groups.first[v],
                          groups.sides.data() + groups.first[v + 1]);
    std::ranges::stable_sort(group, {}, &Side::to);
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (i == 0 || group[i].to != group[i - 1].to) {
        edges.push_back({VertexId(v), VertexId(group[i].to), group[i].face, group[i].face, 0, 0});
      }
      edges.back().lastFace = group[i].face;
      ++edges.back().uses;
    }
  }
  markModelEdges(mesh, edges);
  return edges;
}

}  // namespace af2::geometry
