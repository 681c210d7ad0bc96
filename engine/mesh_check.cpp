#include "engine/mesh_check.h"

#include <algorithm>
#include <cmath>

namespace af2 {
namespace {

using Edge = std::pair<VertexId, VertexId>;

/// The directed edges of a mesh in groups by their first vertex: linear to make, short to search.
class EdgeTable {
 public:
  struct Entry {
    VertexId to;
    ElementId element;
  };

  void add(VertexId from, VertexId to, ElementId element) {
    added_.push_back({{from, to}, element});
  }

  void sort(std::size_t vertexCount) {
    first_.assign(vertexCount + 2, 0);
    for (const auto& [edge, element] : added_) ++first_[edge.first.value + 2];
    for (std::size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
    entries_.resize(added_.size());
    for (const auto& [edge, element] : added_)
      entries_[first_[edge.first.value + 1]++] = {edge.second, element};
    added_ = {};
  }

  std::span<const Entry> from(VertexId v) const {
    return {entries_.data() + first_[v.value], first_[v.value + 1] - first_[v.value]};
  }
  std::size_t count(VertexId from, VertexId to) const {
    std::size_t n = 0;
    for (const Entry& e : this->from(from)) n += e.to == to;
    return n;
  }

 private:
  std::vector<std::pair<Edge, ElementId>> added_;
  std::vector<std::uint32_t> first_;
  std::vector<Entry> entries_;
};

class Checker {
 public:
  Checker(const Mesh& mesh, const MeshBoundary& boundary) : mesh_(mesh), boundary_(boundary) {}

  std::vector<MeshFault> check() {
    for (std::size_t i = 0; i < mesh_.elements.size(); ++i) checkElement(ElementId(i));
    edges_.sort(mesh_.vertices.size());
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) checkVertex(VertexId(v));
    for (const Edge& e : boundary_.edges)
      if (edges_.count(e.first, e.second) == 0)
        add(MeshFault::Kind::BoundaryNotKept, {}, e.first, e.second);
    return std::move(faults_);
  }

 private:
  void add(MeshFault::Kind kind, ElementId element, VertexId from = {}, VertexId to = {}) {
    faults_.push_back({kind, element, from, to});
  }

  void checkElement(ElementId id) {
    const auto corners = mesh_.elements[id.value].vertices();
    for (VertexId v : corners) {
      if (v.value < mesh_.vertices.size() && std::count(corners.begin(), corners.end(), v) == 1)
        continue;
      add(MeshFault::Kind::BadElement, id, v);
      return;
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
      edges_.add(corners[i], corners[i + 1 == corners.size() ? 0 : i + 1], id);
    if (!facesTheNormals(corners)) add(MeshFault::Kind::Inverted, id);
  }

  bool facesTheNormals(std::span<const VertexId> corners) const {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const auto at = [&](std::size_t k) -> const SurfacePoint& {
        return mesh_.vertices[corners[k].value];
      };
      const SurfacePoint& corner = at(i);
      const Point3 ahead = at(i + 1 == n ? 0 : i + 1).position - corner.position;
      const Point3 behind = at(i == 0 ? n - 1 : i - 1).position - corner.position;
      if (corner.normal != Point3{} && !(dot(cross(ahead, behind), corner.normal) > 0))
        return false;
    }
    return true;
  }

  void checkVertex(VertexId v) {
    const auto outgoing = edges_.from(v);
    if (outgoing.empty()) add(MeshFault::Kind::UnusedVertex, {}, v);
    for (std::size_t i = 0; i < outgoing.size(); ++i) {
      const auto [to, element] = outgoing[i];
      for (std::size_t j = 0; j < i; ++j)
        if (outgoing[j].to == to) add(MeshFault::Kind::OverlappingEdge, element, v, to);
      const bool hasPartner = edges_.count(to, v) > 0;
      const bool isGiven = boundary_.contains(v, to);
      if (!hasPartner && !isGiven) add(MeshFault::Kind::OpenEdge, element, v, to);
      if (hasPartner && isGiven && !boundary_.contains(to, v))
        add(MeshFault::Kind::BoundaryNotKept, element, v, to);
    }
  }

  const Mesh& mesh_;
  const MeshBoundary& boundary_;
  EdgeTable edges_;
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

std::vector<MeshFault> checkMesh(const Mesh& mesh, const MeshBoundary& boundary) {
  return Checker(mesh, boundary).check();
}

std::string faultOf(const Mesh& mesh, const MeshBoundary& boundary) {
  const std::vector<MeshFault> faults = checkMesh(mesh, boundary);
  if (faults.empty()) return "";
  return "the mesh has " + std::to_string(faults.size()) +
         " faults: " + describe(faults.front(), mesh);
}

}  // namespace af2
