#include "engine/mesh/mesh_topology.h"

#include <algorithm>
#include <cmath>

#include "engine/base/elementary.h"
#include "engine/base/error.h"

namespace af2 {
namespace {

void forAllCorners(const Mesh& mesh, auto&& visit) {
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (std::size_t i = 0; i < static_cast<std::size_t>(mesh.elements[e].size()); ++i)
      visit(Corner(e, i));
}

}  // namespace

MeshTopology::MeshTopology(Mesh& mesh, const MeshBoundary& boundary)
    : mesh_(mesh),
      fixedCount_(boundary.fixedCount),
      across_(4 * mesh.elements.size()),
      cornerOf_(mesh.vertices.size()),
      valence_(mesh.vertices.size(), 0),
      grades_(mesh.elements.size(), 0) {
  AF2_CHECK(mesh.elements.size() < (1u << 29), "a region has fewer than 2^29 elements");
  pairSides();
  findCorners(boundary);
}

/// Sides whose other element has not come yet wait in a list for the smaller of their vertices. The
/// list begins in `cornerOf_` and goes on in `across_`, which have nothing else to hold so far.
void MeshTopology::pairSides() {
  forAllCorners(mesh_, [&](Corner c) {
    const VertexId from = vertexAt(c), to = vertexAt(next(c));
    Corner* link = &cornerOf_[std::min(from, to).value];
    while (!link->isNone() && (vertexAt(*link) != to || vertexAt(next(*link)) != from))
      link = &across_[static_cast<std::size_t>(link->code)];
    const Corner partner = *link;
    if (partner.isNone()) {
      *link = c;
    } else {
      *link = across(partner);
      setAcross(c, partner);
    }
  });
  for (Corner& waiting : cornerOf_)
    while (!waiting.isNone()) {
      const Corner side = std::exchange(waiting, across(waiting));
      across_[static_cast<std::size_t>(side.code)] = Corner();
    }
}

/// Joins two sides; a side without a partner lies on the rim.
void MeshTopology::setAcross(Corner c, Corner d) {
  if (!c.isNone()) across_[static_cast<std::size_t>(c.code)] = d;
  if (!d.isNone()) across_[static_cast<std::size_t>(d.code)] = c;
}

/// Lines inside the region, and seams, have elements on both sides; they must stay edges.
void MeshTopology::findCorners(const MeshBoundary& boundary) {
  forAllCorners(mesh_, [&](Corner c) {
    const VertexId v = vertexAt(c);
    if (!across(c).isNone() && boundary.contains(v, vertexAt(next(c)))) {
      setAcross(across(c), Corner());
      setAcross(c, Corner());
    }
    Corner& first = cornerOf_[v.value];
    if (first.isNone() || across(c).isNone()) first = c;
    std::uint8_t& valence = valence_[v.value];
    if (valence < 255) ++valence;
  });
}

std::vector<double> MeshTopology::anglesAtFixed() const {
  std::vector<double> angles(fixedCount_, 0);
  const auto at = [&](Corner c) -> const Point3& {
    return mesh_.vertices[vertexAt(c).value].position;
  };
  for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
    const auto& [v, w, x, y] = mesh_.elements[e].corners;
    if (!(isFixed(v) | isFixed(w) | isFixed(x) | isFixed(y))) continue;  // as most elements
    for (std::size_t i = 0; i < static_cast<std::size_t>(mesh_.elements[e].size()); ++i) {
      const Corner c(e, i);
      if (!isFixed(vertexAt(c))) continue;
      const Point3 p = at(next(c)) - at(c), q = at(previous(c)) - at(c);
      angles[vertexAt(c).value] += angleBetween(p, q);
    }
  }
  return angles;
}

bool MeshTopology::areJoined(VertexId u, VertexId v) const {
  const Corner first = cornerOf(u);
  for (Corner c = first; !c.isNone();) {
    if (vertexAt(next(c)) == v || vertexAt(previous(c)) == v) return true;
    c = aroundVertex(c);
    if (c == first) break;
  }
  return false;
}

void MeshTopology::swap(Corner side) {
  const Corner other = across(side);
  const std::size_t s = side.element(), t = other.element();
  const VertexId a = vertexAt(side), b = vertexAt(next(side));
  const VertexId c = vertexAt(previous(side)), d = vertexAt(previous(other));
  const Corner bc = across(next(side)), ca = across(previous(side));
  const Corner ad = across(next(other)), db = across(previous(other));

  mesh_.elements[s].corners = {a, d, c, VertexId()};
  mesh_.elements[t].corners = {d, b, c, VertexId()};
  setAcross({s, 0}, ad);
  setAcross({s, 2}, ca);
  setAcross({t, 0}, db);
  setAcross({t, 1}, bc);
  setAcross({s, 1}, {t, 2});

  --valence_[a.value];
  --valence_[b.value];
  ++valence_[c.value];
  ++valence_[d.value];
  renewCornerOf({s, 0});
  renewCornerOf({s, 1});
  renewCornerOf({s, 2});
  renewCornerOf({t, 1});
  noteChange(s);
  noteChange(t);
}

void MeshTopology::collapse(Corner side) {
  const Corner other = across(side);
  const VertexId from = vertexAt(side), to = vertexAt(next(side));
  // The sides of the two vanishing triangles: the neighbour beyond the side at `from` and the one
  // beyond the side at `to` become neighbours.
  const Corner leftAtTo = across(next(side)), leftAtFrom = across(previous(side));
  const Corner rightAtTo = across(previous(other)), rightAtFrom = across(next(other));
  const std::size_t s = side.element(), t = other.element();

  std::vector<Corner> star;
  for (Corner c = aroundVertex(side); c != side; c = aroundVertex(c)) star.push_back(c);
  for (Corner c : star) {
    mesh_.elements[c.element()].corners[c.index()] = to;
    noteChange(c.element());
  }
  --valence_[vertexAt(previous(side)).value];
  --valence_[vertexAt(previous(other)).value];
  valence_[to.value] = static_cast<std::uint8_t>(valence_[to.value] + valence_[from.value] - 4);
  valence_[from.value] = 0;
  cornerOf_[from.value] = Corner();
  for (std::size_t e : {s, t}) mesh_.elements[e].corners = {};

  setAcross(leftAtTo, leftAtFrom);
  setAcross(rightAtTo, rightAtFrom);
  renewCornerOf(leftAtFrom);
  renewCornerOf(next(leftAtFrom));
  renewCornerOf(rightAtFrom);
}

VertexId MeshTopology::addVertex(const SurfacePoint& point) {
  const VertexId v(mesh_.vertices.size());
  mesh_.vertices.push_back(point);
  cornerOf_.emplace_back();
  valence_.push_back(0);
  return v;
}

void MeshTopology::move(VertexId v, const SurfacePoint& point) {
  mesh_.vertices[v.value] = point;
  changed_.push_back(v);
  forEachCornerOf(v, [&](Corner c) { dropGrade(c.element()); });
}

std::vector<std::size_t> MeshTopology::replace(std::vector<std::size_t> places,
                                               std::span<const Element> elements) {
  struct Side {
    VertexId from, to;
    Corner beyond;
  };
  const auto forEachCorner = [&](std::size_t count, auto&& visit) {
    for (const std::size_t e : std::span(places).first(count))
      for (std::size_t i = 0; i < static_cast<std::size_t>(mesh_.elements[e].size()); ++i)
        visit(Corner(e, i));
  };
  std::vector<Side> outline;
  forEachCorner(places.size(), [&](Corner c) {
    const Corner beyond = across(c);
    if (beyond.isNone() || std::ranges::find(places, beyond.element()) == places.end())
      outline.push_back({vertexAt(c), vertexAt(next(c)), beyond});
    --valence_[vertexAt(c).value];
    cornerOf_[vertexAt(c).value] = Corner();
  });
  for (const std::size_t e : places) noteChange(e);
  while (places.size() < elements.size()) {
    places.push_back(mesh_.elements.size());
    mesh_.elements.emplace_back();
    mesh_.origins.push_back(mesh_.origins[places[0]]);
    across_.resize(4 * mesh_.elements.size());
    grades_.push_back(0);
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    mesh_.elements[places[k]] = k < elements.size() ? elements[k] : Element();
    for (std::size_t i = 0; i < 4; ++i)
      across_[static_cast<std::size_t>(Corner(places[k], i).code)] = Corner();
  }
  forEachCorner(elements.size(), [&](Corner c) {
    const VertexId from = vertexAt(c), to = vertexAt(next(c));
    ++valence_[from.value];
    for (const Side& side : outline)
      if (side.from == from && side.to == to) return setAcross(c, side.beyond);
    forEachCorner(elements.size(), [&](Corner d) {
      if (vertexAt(d) == to && vertexAt(next(d)) == from) setAcross(c, d);
    });
  });
  forEachCorner(elements.size(), [&](Corner c) { renewCornerOf(c); });
  for (const std::size_t e : std::span(places).first(elements.size())) noteChange(e);
  places.resize(elements.size());
  return places;
}

/// Makes a corner, or on the rim the first corner clockwise of it, the corner of its vertex.
void MeshTopology::renewCornerOf(Corner c) {
  const VertexId v = vertexAt(c);
  cornerOf_[v.value] = c;
  for (Corner d = across(c); !d.isNone(); d = across(cornerOf_[v.value])) {
    if (next(d) == c) return;
    cornerOf_[v.value] = next(d);
  }
}

void MeshTopology::compact() {
  std::vector<VertexId> renumbered(mesh_.vertices.size());
  std::size_t vertices = 0, elements = 0;
  for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
    if (v >= fixedCount_ && valence_[v] == 0) continue;
    mesh_.vertices[vertices] = mesh_.vertices[v];
    renumbered[v] = VertexId(vertices++);
  }
  mesh_.vertices.resize(vertices);
  for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
    if (isDead(e)) continue;
    Element element = mesh_.elements[e];
    for (VertexId& v : element.corners)
      if (!v.isNone()) v = renumbered[v.value];
    mesh_.origins[elements] = mesh_.origins[e];
    mesh_.elements[elements++] = element;
  }
  mesh_.elements.resize(elements);
  mesh_.origins.resize(elements);
}

}  // namespace af2
