#include "engine/mesh_check.h"

#include <algorithm>
#include <cmath>

namespace af2 {
namespace {

struct DirectedEdge {
  VertexId from, to;
  ElementId element;
  auto key() const { return std::pair(from, to); }
};

bool byKey(const DirectedEdge& e, const DirectedEdge& f) { return e.key() < f.key(); }

class Checker {
 public:
  Checker(const Mesh& mesh, const FrontInput& input) : mesh_(mesh) {
    for (const auto& loop : input.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        boundary_.push_back({loop[i].vertex, loop[(i + 1) % loop.size()].vertex, ElementId()});
    std::sort(boundary_.begin(), boundary_.end(), byKey);
  }

  std::vector<MeshFault> check() {
    for (std::size_t i = 0; i < mesh_.elements.size(); ++i) checkElement(ElementId(i));
    std::sort(edges_.begin(), edges_.end(), byKey);
    for (std::size_t i = 0; i < edges_.size(); ++i) checkEdge(i);
    for (const DirectedEdge& e : boundary_)
      if (!find(edges_, e.from, e.to)) add(MeshFault::Kind::BoundaryNotKept, {}, e.from, e.to);
    checkVertices();
    return std::move(faults_);
  }

 private:
  void add(MeshFault::Kind kind, ElementId element, VertexId from = {}, VertexId to = {}) {
    faults_.push_back({kind, element, from, to});
  }

  static bool find(const std::vector<DirectedEdge>& edges, VertexId from, VertexId to) {
    return std::binary_search(edges.begin(), edges.end(), DirectedEdge{from, to, {}}, byKey);
  }

  void checkElement(ElementId id) {
    const auto corners = mesh_.elements[id.value].vertices();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const bool isRepeated = std::count(corners.begin(), corners.end(), corners[i]) > 1;
      if (corners[i].value >= mesh_.vertices.size() || isRepeated) {
        add(MeshFault::Kind::BadElement, id, corners[i]);
        return;
      }
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
      edges_.push_back({corners[i], corners[(i + 1) % corners.size()], id});
    if (!facesTheNormals(corners)) add(MeshFault::Kind::Inverted, id);
  }

  bool facesTheNormals(std::span<const VertexId> corners) const {
    const auto at = [&](std::size_t i) -> const SurfacePoint& {
      return mesh_.vertices[corners[i % corners.size()].value];
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point3 ahead = at(i + 1).position - at(i).position;
      const Point3 behind = at(i + corners.size() - 1).position - at(i).position;
      if (at(i).normal != Point3{} && !(dot(cross(ahead, behind), at(i).normal) > 0)) return false;
    }
    return true;
  }

  void checkEdge(std::size_t i) {
    const DirectedEdge& e = edges_[i];
    if (i > 0 && edges_[i - 1].key() == e.key())
      add(MeshFault::Kind::OverlappingEdge, e.element, e.from, e.to);
    const bool hasPartner = find(edges_, e.to, e.from);
    const bool isBoundary = find(boundary_, e.from, e.to);
    if (!hasPartner && !isBoundary) add(MeshFault::Kind::OpenEdge, e.element, e.from, e.to);
    if (isBoundary && hasPartner && !find(boundary_, e.to, e.from))
      add(MeshFault::Kind::BoundaryNotKept, e.element, e.from, e.to);
  }

  void checkVertices() {
    std::vector<bool> isUsed(mesh_.vertices.size(), false);
    for (const DirectedEdge& e : edges_) isUsed[e.from.value] = true;
    for (std::size_t v = 0; v < isUsed.size(); ++v)
      if (!isUsed[v]) add(MeshFault::Kind::UnusedVertex, {}, VertexId(v));
  }

  const Mesh& mesh_;
  std::vector<DirectedEdge> edges_, boundary_;
  std::vector<MeshFault> faults_;
};

const char* toString(MeshFault::Kind kind) {
  switch (kind) {
    case MeshFault::Kind::BadElement:
      return "an element repeats a vertex or names an unknown one";
    case MeshFault::Kind::OverlappingEdge:
      return "two elements use an edge in the same direction";
    case MeshFault::Kind::OpenEdge:
      return "an edge has an element on one side only";
    case MeshFault::Kind::BoundaryNotKept:
      return "a boundary edge was not kept";
    case MeshFault::Kind::Inverted:
      return "an element is turned against the surface";
    case MeshFault::Kind::UnusedVertex:
      return "a vertex is used by no element";
  }
  return "unknown fault";
}

}  // namespace

std::string describe(const MeshFault& fault, const Mesh& mesh) {
  std::string text = toString(fault.kind);
  if (!fault.element.isNone()) text += ", element " + std::to_string(fault.element.value);
  if (!fault.from.isNone()) text += ", vertex " + std::to_string(fault.from.value);
  if (!fault.to.isNone()) text += " -> " + std::to_string(fault.to.value);
  const VertexId where = !fault.from.isNone() ? fault.from
                         : !fault.element.isNone() && fault.element.value < mesh.elements.size()
                             ? mesh.elements[fault.element.value].corners[0]
                             : VertexId();
  if (where.value < mesh.vertices.size()) {
    const Point3& p = mesh.vertices[where.value].position;
    text += ", at (" + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " +
            std::to_string(p.z) + ")";
  }
  return text;
}

std::vector<MeshFault> checkMesh(const Mesh& mesh, const FrontInput& input) {
  return Checker(mesh, input).check();
}

}  // namespace af2
