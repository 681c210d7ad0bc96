#include "engine/mesh/mesh_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "engine/base/place_text.h"
#include "engine/mesh/element_shape.h"
#include "engine/mesh/vertex_stars.h"

namespace af2 {
namespace {

using Edge = std::pair<VertexId, VertexId>;

class Checker {
 public:
  Checker(const Mesh& mesh, const MeshBoundary& boundary) : mesh_(mesh), boundary_(boundary) {}

  std::vector<MeshFault> check() {
    for (std::size_t i = 0; i < mesh_.elements.size(); ++i) checkElement(ElementId(i));
    for (std::size_t v = 0; v < mesh_.vertices.size(); v += VertexStars::kMaxAtOnce)
      checkVertices(v, std::min(v + VertexStars::kMaxAtOnce, mesh_.vertices.size()));
    nameElements();
    return std::move(faults_);
  }

 private:
  void add(MeshFault::Kind kind, ElementId element, VertexId from = {}, VertexId to = {}) {
    faults_.push_back({kind, element, from, to});
  }

  void checkElement(ElementId id) {
    const Element& element = mesh_.elements[id.value];
    if (!hasProperCorners(element, mesh_.vertices.size())) {
      add(MeshFault::Kind::BadElement, id, improperCorner(element));
      bad_.push_back(id);
      return;
    }
    if (!facesTheNormals(element.vertices())) add(MeshFault::Kind::Inverted, id);
  }

  VertexId improperCorner(const Element& element) const {
    const auto corners = element.vertices();
    return *std::ranges::find_if(corners, [&](VertexId v) {
      return v.value >= mesh_.vertices.size() || std::ranges::count(corners, v) > 1;
    });
  }

  void checkVertices(std::size_t begin, std::size_t end) {
    VertexStars stars(begin, end);
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
      if (!isBad(e)) stars.add(mesh_.elements[e]);
    stars.finish();
    for (std::size_t v = begin; v < end; ++v) checkVertex(VertexId(v), stars);
    auto edge = std::ranges::lower_bound(boundary_.edges, VertexId(begin), {}, &Edge::first);
    for (; edge != boundary_.edges.end() && edge->first.value < end; ++edge)
      if (!hasEdge(edge->first, edge->second, stars))
        add(MeshFault::Kind::BoundaryNotKept, {}, edge->first, edge->second);
  }

  bool isBad(std::size_t element) const {
    return !bad_.empty() && std::ranges::binary_search(bad_, ElementId(element));
  }

  bool hasEdge(VertexId from, VertexId to, const VertexStars& stars) {
    stars.corners(from.value, corners_);
    return std::ranges::find(corners_, to.value, &VertexStars::Corner::next) != corners_.end();
  }

  bool facesTheNormals(std::span<const VertexId> corners) const {
    const std::size_t n = corners.size();
    if (n == 3 && facesAllNormals(corners)) return true;
    std::array<const SurfacePoint*, 4> at{};
    for (std::size_t i = 0; i < n; ++i) at[i] = &mesh_.vertices[corners[i].value];
    for (std::size_t i = 0; i < n; ++i) {
      const SurfacePoint& corner = *at[i];
      const Point3 ahead = at[i + 1 == n ? 0 : i + 1]->position - corner.position;
      const Point3 behind = at[i == 0 ? n - 1 : i - 1]->position - corner.position;
      if (corner.normal != Point3{} && !(dot(cross(ahead, behind), corner.normal) > 0))
        return false;
      if (n == 4 && turnsBackAt(at, i)) return false;
    }
    return true;
  }

  void checkVertex(VertexId v, const VertexStars& stars) {
    if (v.value >= boundary_.fixedCount && stars.areAround(v.value)) return;
    stars.corners(v.value, corners_);
    const std::span<const VertexStars::Corner> corners = corners_;
    if (corners.empty()) add(MeshFault::Kind::UnusedVertex, {}, v);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const VertexId to(corners[i].next);
      std::size_t before = 0;
      bool hasPartner = false;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        before += (k < i) & (corners[k].next == to.value);
        hasPartner |= corners[k].previous == to.value;
      }
      for (std::size_t k = 0; k < before; ++k)
        addAt(MeshFault::Kind::OverlappingEdge, v, to, before);
      const bool isGiven = boundary_.contains(v, to);
      if (!hasPartner && !isGiven) addAt(MeshFault::Kind::OpenEdge, v, to, before);
      if (hasPartner && isGiven && !boundary_.contains(to, v))
        addAt(MeshFault::Kind::BoundaryNotKept, v, to, before);
    }
  }

  /// For a triangle, whose corners all turn like its area. False also where a normal is unknown.
  bool facesAllNormals(std::span<const VertexId> triangle) const {
    const SurfacePoint &a = mesh_.vertices[triangle[0].value],
                       &b = mesh_.vertices[triangle[1].value],
                       &c = mesh_.vertices[triangle[2].value];
    const Point3 area = cross(b.position - a.position, c.position - a.position);
    return (dot(area, a.normal) > 0) & (dot(area, b.normal) > 0) & (dot(area, c.normal) > 0);
  }

  /// A fault at the element that uses the edge v -> to after `before` other elements.
  void addAt(MeshFault::Kind kind, VertexId v, VertexId to, std::size_t before) {
    unnamed_.push_back({faults_.size(), before});
    add(kind, {}, v, to);
  }

  /// Faults are rare: a second walk finds their elements, so that these are not stored for all
  /// edges.
  void nameElements() {
    if (unnamed_.empty()) return;
    std::map<Edge, std::vector<ElementId>> users;
    for (const Unnamed& u : unnamed_) users[{faults_[u.fault].from, faults_[u.fault].to}];
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      if (isBad(e)) continue;
      const auto corners = mesh_.elements[e].vertices();
      for (std::size_t i = 0; i < corners.size(); ++i)
        if (const auto at = users.find({corners[i], corners[(i + 1) % corners.size()]});
            at != users.end())
          at->second.push_back(ElementId(e));
    }
    for (const Unnamed& u : unnamed_)
      faults_[u.fault].element = users[{faults_[u.fault].from, faults_[u.fault].to}][u.before];
  }

  struct Unnamed {
    std::size_t fault, before;
  };

  const Mesh& mesh_;
  const MeshBoundary& boundary_;
  std::vector<VertexStars::Corner> corners_;  ///< of one vertex
  std::vector<ElementId> bad_;                ///< degenerate elements, which have no usable edges
  std::vector<MeshFault> faults_;
  std::vector<Unnamed> unnamed_;
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
      return "a corner of an element turns against the surface normal";
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
  if (where.value < mesh.vertices.size())
    text += ", at " + textOf(mesh.vertices[where.value].position);
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
