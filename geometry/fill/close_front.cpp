#include "geometry/fill/close_front.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "engine/base/predicates.h"
#include "geometry/base/disjoint_sets.h"
#include "geometry/base/plane_axes.h"
#include "geometry/fill/fill_limits.h"

namespace af2::geometry {

namespace {

struct Edge {
  VertexId from, to;
  auto operator<=>(const Edge&) const = default;
};

struct Box {
  Point2 low, high;

  static Box of(Point2 a, Point2 b) {
    return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
  }
  bool isApartFrom(const Box& other) const {
    return high.x < other.low.x || other.high.x < low.x || high.y < other.low.y ||
           other.high.y < low.y;
  }
};

/// An edge of the front in the plane.
struct DrawnEdge {
  Edge edge;
  Point2 from, to;
  double length = 0;
  Box box;
};

class Closer {
 public:
  Closer(const std::vector<StuckEdge>& front, const std::function<Point2(VertexId)>& inPlane)
      : inPlane_(inPlane) {
    for (const StuckEdge& edge : front) front_.push_back(drawn({edge.from, edge.to}));
  }

  /// Nothing if some edge has no triangle.
  std::optional<std::vector<Element>> close() {
    while (!front_.empty()) {
      const DrawnEdge base =
          *std::min_element(front_.begin(), front_.end(), [](const auto& e, const auto& f) {
            return std::pair(e.length, e.edge) < std::pair(f.length, f.edge);
          });
      const std::optional<VertexId> apex = bestApex(base);
      if (!apex) return std::nullopt;
      elements_.push_back({{base.edge.from, base.edge.to, *apex, VertexId()}});
      std::erase_if(front_, [&](const DrawnEdge& e) { return e.edge == base.edge; });
      join({base.edge.from, *apex});
      join({*apex, base.edge.to});
    }
    return std::move(elements_);
  }

 private:
  /// A vertex that may become the third corner of a triangle.
  struct Apex {
    double shape;
    std::size_t edge;  ///< of the front, which starts at the vertex

    bool operator<(const Apex& other) const {
      return shape != other.shape ? shape < other.shape : edge > other.edge;
    }
  };

  DrawnEdge drawn(Edge edge) const {
    const Point2 from = inPlane_(edge.from), to = inPlane_(edge.to);
    return {edge, from, to, distance(from, to), Box::of(from, to)};
  }

  auto find(Edge edge) { return std::ranges::find(front_, edge, &DrawnEdge::edge); }
  bool isOnFront(Edge edge) const {
    return std::ranges::find(front_, edge, &DrawnEdge::edge) != front_.end();
  }

  /// Whether an edge may not be added. Both sides of an edge may be on the front, as along a path
  /// through its region; then the opposite one is closed.
  bool isTaken(Edge edge) const { return isOnFront(edge) && !isOnFront({edge.to, edge.from}); }

  /// Adds an edge to the front, or takes out the opposite one.
  void join(Edge edge) {
    const auto opposite = find({edge.to, edge.from});
    if (opposite == front_.end())
      front_.push_back(drawn(edge));
    else
      front_.erase(opposite);
  }

  /// Of those that are free, the one with the best shape, and the first of several. Mostly it is
  /// among the best few, so that they are not sorted.
  std::optional<VertexId> bestApex(const DrawnEdge& base) {
    apexes_.clear();
    for (std::size_t i = 0; i < front_.size(); ++i) {
      const VertexId from = front_[i].edge.from;
      if (from != base.edge.from && from != base.edge.to)
        apexes_.push_back({shapeOf(base, front_[i].from), i});
    }
    std::make_heap(apexes_.begin(), apexes_.end());
    for (auto end = apexes_.end(); end != apexes_.begin(); --end) {
      std::pop_heap(apexes_.begin(), end);
      const DrawnEdge& best = front_[(end - 1)->edge];
      if (isFree(base, best.edge.from, best.from)) return best.edge.from;
    }
    return std::nullopt;
  }

  /// Area over squared edges.
  static double shapeOf(const DrawnEdge& base, Point2 c) {
    const Point2 a = base.from, b = base.to;
    return std::abs(cross(b - a, c - a)) /
           (dot(b - a, b - a) + dot(c - b, c - b) + dot(a - c, a - c));
  }

  bool isFree(const DrawnEdge& base, VertexId apex, Point2 c) const {
    const Point2 a = base.from, b = base.to;
    if (orientation(a, b, c) != Turn::Left) return false;
    const DrawnEdge left{{base.edge.from, apex}, a, c, 0, {}};
    const DrawnEdge right{{apex, base.edge.to}, c, b, 0, {}};
    if (isTaken(left.edge) || isTaken(right.edge)) return false;
    const Box triangle{{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
                       {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}};
    for (const DrawnEdge& e : front_) {
      if (triangle.isApartFrom(e.box)) continue;  // predicates are exact: they would say so, too
      const VertexId from = e.edge.from;
      const bool isCorner = from == base.edge.from || from == base.edge.to || from == apex;
      if (!isCorner && holds(a, b, c, e.from)) return false;
      if (crosses(left, e) || crosses(right, e)) return false;
    }
    return true;
  }

  static bool holds(Point2 a, Point2 b, Point2 c, Point2 p) {
    return orientation(a, b, p) != Turn::Right && orientation(b, c, p) != Turn::Right &&
           orientation(c, a, p) != Turn::Right;
  }

  static bool crosses(const DrawnEdge& side, const DrawnEdge& e) {
    const auto isEnd = [&](VertexId v) { return v == e.edge.from || v == e.edge.to; };
    return !isEnd(side.edge.from) && !isEnd(side.edge.to) &&
           segmentsMeet(side.from, side.to, e.from, e.to);
  }

  const std::function<Point2(VertexId)>& inPlane_;
  std::vector<DrawnEdge> front_;
  std::vector<Apex> apexes_;
  std::vector<Element> elements_;
};

/// Those edges of a front that make a loop with the first one; nothing if they are ambiguous.
std::vector<StuckEdge> takeLoop(std::vector<StuckEdge>& front) {
  std::vector<StuckEdge> loop{front.front()};
  front.erase(front.begin());
  while (loop.back().to != loop.front().from) {
    const auto starts = [&](const StuckEdge& e) { return e.from == loop.back().to; };
    const auto next = std::ranges::find_if(front, starts);
    if (next == front.end() || std::ranges::count_if(front, starts) > 1) return {};
    loop.push_back(*next);
    front.erase(next);
  }
  return loop;
}

/// Twice the area of a loop, across it.
Point3 areaVector(const Mesh& mesh, const std::vector<StuckEdge>& loop) {
  const Point3& origin = mesh.vertices[loop.front().from.value].position;
  Point3 sum;
  for (const StuckEdge& edge : loop)
    sum = sum + cross(mesh.vertices[edge.from.value].position - origin,
                      mesh.vertices[edge.to.value].position - origin);
  return sum;
}

/// The plane across the mean normal of the vertices of a front.
ProjectionFrame planeOfFront(const Mesh& mesh, const std::vector<StuckEdge>& front) {
  Point3 normal;
  for (const StuckEdge& edge : front) normal = normal + mesh.vertices[edge.from.value].normal;
  normal = unit(normal);
  ProjectionFrame frame;
  frame.origin = mesh.vertices[front.front().from.value].position;
  const PlaneAxes axes(frame.origin, normal);
  frame.xAxis = axes.xAxis();
  frame.yAxis = axes.yAxis();
  frame.normal = normal;
  return frame;
}

std::optional<std::vector<Element>> closedInItsPlane(const Mesh& mesh,
                                                     const std::vector<StuckEdge>& front) {
  const ProjectionFrame plane = planeOfFront(mesh, front);
  const std::function<Point2(VertexId)> inPlane = [&](VertexId v) {
    return plane.project(mesh.vertices[v.value]).position;
  };
  return Closer(front, inPlane).close();
}

/// A part of a front, and its triangles if it could be closed.
struct FrontPart {
  std::vector<StuckEdge> edges;
  std::optional<std::vector<Element>> elements;
};

/// Edges that share vertices belong together.
std::vector<FrontPart> connectedParts(const std::vector<StuckEdge>& front) {
  std::map<std::uint32_t, std::uint32_t> firstAt;  // edge by vertex
  DisjointSets sets(front.size());
  for (std::uint32_t i = 0; i < front.size(); ++i)
    for (const VertexId v : {front[i].from, front[i].to})
      sets.join(i, firstAt.emplace(v.value, i).first->second);
  std::map<std::uint32_t, FrontPart> parts;
  for (std::uint32_t i = 0; i < front.size(); ++i) parts[sets.of(i)].edges.push_back(front[i]);
  std::vector<FrontPart> inOrder;
  for (auto& [first, part] : parts) inOrder.push_back(std::move(part));
  return inOrder;
}

double distanceBetween(const Mesh& mesh, const FrontPart& one, const FrontPart& other) {
  double least = std::numeric_limits<double>::infinity();
  for (const StuckEdge& e : one.edges)
    for (const StuckEdge& f : other.edges)
      least = std::min(least, distance(mesh.vertices[e.from.value].position,
                                       mesh.vertices[f.from.value].position));
  return least;
}

/// Makes one of a part and the one nearest to it.
void joinWithNearest(const Mesh& mesh, std::vector<FrontPart>& parts, std::size_t which) {
  FrontPart joined = std::move(parts[which]);
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(which));
  const auto nearest = std::ranges::min_element(
      parts, {}, [&](const FrontPart& other) { return distanceBetween(mesh, joined, other); });
  nearest->edges.insert(nearest->edges.end(), joined.edges.begin(), joined.edges.end());
  nearest->elements.reset();
}

/// Each part of a front in a plane of its own: those around a torus have no plane in common. Parts
/// that cannot be closed alone are those inside others, which are closed together with these.
std::optional<std::vector<Element>> closedInParts(const Mesh& mesh,
                                                  const std::vector<StuckEdge>& front) {
  std::vector<FrontPart> parts = connectedParts(front);
  const auto isOpen = [](const FrontPart& part) { return !part.elements; };
  for (auto open = parts.begin(); open != parts.end(); open = std::ranges::find_if(parts, isOpen)) {
    open->elements = closedInItsPlane(mesh, open->edges);
    if (open->elements) continue;
    if (parts.size() == 1) return std::nullopt;
    joinWithNearest(mesh, parts, static_cast<std::size_t>(open - parts.begin()));
  }
  std::vector<Element> elements;
  for (const FrontPart& part : parts)
    elements.insert(elements.end(), part.elements->begin(), part.elements->end());
  return elements;
}

void complete(MeshingResult& result, const std::vector<Element>& elements, ElementOrigin origin) {
  result.mesh.elements.insert(result.mesh.elements.end(), elements.begin(), elements.end());
  result.mesh.origins.insert(result.mesh.origins.end(), elements.size(), origin);
  result.stuck.clear();
  result.outcome = Outcome::Complete;
}

}  // namespace

bool closeFront(MeshingResult& result, const std::function<Point2(VertexId)>& inPlane,
                ElementOrigin origin, std::size_t most) {
  if (result.stuck.empty() || result.stuck.size() > most) return false;
  const auto elements = Closer(result.stuck, inPlane).close();
  if (elements) complete(result, *elements, origin);
  return elements.has_value();
}

bool closeFront(MeshingResult& result, ElementOrigin origin, std::size_t most) {
  if (result.stuck.empty() || result.stuck.size() > most) return false;
  auto elements = closedInItsPlane(result.mesh, result.stuck);
  if (!elements) elements = closedInParts(result.mesh, result.stuck);
  if (elements) complete(result, *elements, origin);
  return elements.has_value();
}

bool closeLoops(MeshingResult& result, ElementOrigin origin) {
  MeshingResult closed = result;
  std::vector<StuckEdge> front = result.stuck;
  while (!front.empty()) {
    closed.stuck = takeLoop(front);
    if (closed.stuck.size() < 3) return false;
    const Point3 across = areaVector(closed.mesh, closed.stuck);
    if (!(length(across) > 0)) return false;
    const PlaneAxes axes(closed.mesh.vertices[closed.stuck.front().from.value].position,
                         unit(across));
    const auto inPlane = [&](VertexId v) { return axes(closed.mesh.vertices[v.value]); };
    if (!closeFront(closed, inPlane, origin, kMaxLoopEdges)) return false;
  }
  result = std::move(closed);
  return true;
}

}  // namespace af2::geometry
