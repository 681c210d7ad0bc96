#include "engine/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/place_text.h"

namespace af2 {
namespace {

using Edge = std::pair<VertexId, VertexId>;

/// The corners of all elements in groups by their vertex: linear to make, short to search. The
/// edges that leave a vertex and those that arrive there lie side by side.
class CornerTable {
 public:
  struct Corner {
    VertexId previous, next;  ///< in the element
  };

  /// bad  elements to leave out, in order
  void make(const Mesh& mesh, const std::vector<ElementId>& bad) {
    first_.assign(mesh.vertices.size() + 2, 0);
    forEachCorner(mesh, bad, [&](VertexId v, Corner, ElementId) { ++first_[v.value + 2]; });
    for (std::size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
    corners_.resize(first_.back());
    forEachCorner(mesh, bad, [&](VertexId v, Corner corner, ElementId) {
      corners_[first_[v.value + 1]++] = corner;
    });
  }

  std::span<const Corner> at(VertexId v) const {
    return {corners_.data() + first_[v.value], first_[v.value + 1] - first_[v.value]};
  }
  bool hasEdge(VertexId from, VertexId to) const {
    return std::ranges::any_of(at(from), [&](const Corner& corner) { return corner.next == to; });
  }

  template <class Visit>
  static void forEachCorner(const Mesh& mesh, const std::vector<ElementId>& bad, Visit&& visit) {
    auto nextBad = bad.begin();
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      if (nextBad != bad.end() && nextBad->value == e) {
        ++nextBad;
        continue;
      }
      const auto corners = mesh.elements[e].vertices();
      const std::size_t n = corners.size();
      for (std::size_t i = 0; i < n; ++i)
        visit(corners[i], Corner{corners[i == 0 ? n - 1 : i - 1], corners[i + 1 == n ? 0 : i + 1]},
              ElementId(e));
    }
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<Corner> corners_;
};

class Checker {
 public:
  Checker(const Mesh& mesh, const MeshBoundary& boundary) : mesh_(mesh), boundary_(boundary) {}

  std::vector<MeshFault> check() {
    for (std::size_t i = 0; i < mesh_.elements.size(); ++i) checkElement(ElementId(i));
    corners_.make(mesh_, bad_);
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) checkVertex(VertexId(v));
    for (const Edge& e : boundary_.edges)
      if (!corners_.hasEdge(e.first, e.second))
        add(MeshFault::Kind::BoundaryNotKept, {}, e.first, e.second);
    nameElements();
    return std::move(faults_);
  }

 private:
  void add(MeshFault::Kind kind, ElementId element, VertexId from = {}, VertexId to = {}) {
    faults_.push_back({kind, element, from, to});
  }

  void checkElement(ElementId id) {
    const auto corners = mesh_.elements[id.value].vertices();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const VertexId v = corners[i];
      bool isRepeated = false;
      for (std::size_t k = 0; k < corners.size(); ++k) isRepeated |= (k != i) & (corners[k] == v);
      if (v.value < mesh_.vertices.size() && !isRepeated) continue;
      add(MeshFault::Kind::BadElement, id, v);
      bad_.push_back(id);
      return;
    }
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

  /// Whether every edge that leaves a vertex leaves it once, and arrives there, too: so it is at
  /// nearly all vertices inside. False also of very many corners.
  static bool areAllAround(std::span<const CornerTable::Corner> corners) {
    constexpr std::size_t kMost = 32;
    const std::size_t n = corners.size();
    if (n == 0 || n > kMost) return false;
    std::uint64_t matched = 0;  // corners whose edge arrives from where another one's goes
    for (const auto& leaving : corners) {
      std::uint64_t arriving = 0;
      for (std::size_t k = 0; k < n; ++k)
        arriving |= std::uint64_t{corners[k].previous == leaving.next} << k;
      if (arriving == 0 || (arriving & matched) != 0) return false;
      matched |= arriving;
    }
    return true;  // n sets of corners, none empty, none with a common corner: one corner in each
  }

  void checkVertex(VertexId v) {
    const auto corners = corners_.at(v);
    if (v.value >= boundary_.fixedCount && areAllAround(corners)) return;
    if (corners.empty()) add(MeshFault::Kind::UnusedVertex, {}, v);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const VertexId to = corners[i].next;
      std::size_t before = 0;
      bool hasPartner = false;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        before += (k < i) & (corners[k].next == to);
        hasPartner |= corners[k].previous == to;
      }
      for (std::size_t k = 0; k < before; ++k)
        addAt(MeshFault::Kind::OverlappingEdge, v, to, before);
      const bool isGiven = boundary_.contains(v, to);
      if (!hasPartner && !isGiven) addAt(MeshFault::Kind::OpenEdge, v, to, before);
      if (hasPartner && isGiven && !boundary_.contains(to, v))
        addAt(MeshFault::Kind::BoundaryNotKept, v, to, before);
    }
  }

  /// A fault at the element that uses the edge v -> to after `before` others that do.
  void addAt(MeshFault::Kind kind, VertexId v, VertexId to, std::size_t before) {
    unnamed_.push_back({faults_.size(), before});
    add(kind, {}, v, to);
  }

  /// Faults are rare: what elements they lie at is found in one more walk, not kept for all edges.
  void nameElements() {
    if (unnamed_.empty()) return;
    std::map<Edge, std::vector<ElementId>> users;
    for (const Unnamed& u : unnamed_) users[{faults_[u.fault].from, faults_[u.fault].to}];
    CornerTable::forEachCorner(
        mesh_, bad_, [&](VertexId v, CornerTable::Corner corner, ElementId id) {
          if (const auto at = users.find({v, corner.next}); at != users.end())
            at->second.push_back(id);
        });
    for (const Unnamed& u : unnamed_)
      faults_[u.fault].element = users[{faults_[u.fault].from, faults_[u.fault].to}][u.before];
  }

  struct Unnamed {
    std::size_t fault, before;
  };

  const Mesh& mesh_;
  const MeshBoundary& boundary_;
  CornerTable corners_;
  std::vector<ElementId> bad_;  ///< elements that have no edges to speak of
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
