#include "geometry/fill/close_front.h"

#include <algorithm>
#include <optional>

#include "engine/base/predicates.h"
#include "geometry/base/plane_axes.h"
#include "geometry/fill/fill_limits.h"

namespace af2::geometry {

namespace {

struct Edge {
  VertexId from, to;
  auto operator<=>(const Edge&) const = default;
};

class Closer {
 public:
  Closer(const MeshingResult& result, const std::function<Point2(VertexId)>& inPlane)
      : inPlane_(inPlane) {
    for (const StuckEdge& edge : result.stuck) front_.push_back({edge.from, edge.to});
  }

  /// Nothing if some edge has no triangle.
  std::optional<std::vector<Element>> close() {
    while (!front_.empty()) {
      const Edge base = *std::min_element(front_.begin(), front_.end(), [&](Edge e, Edge f) {
        return std::pair(lengthOf(e), e) < std::pair(lengthOf(f), f);
      });
      const std::optional<VertexId> apex = bestApex(base);
      if (!apex) return std::nullopt;
      elements_.push_back({{base.from, base.to, *apex, VertexId()}});
      std::erase(front_, base);
      join({base.from, *apex});
      join({*apex, base.to});
    }
    return std::move(elements_);
  }

 private:
  double lengthOf(Edge e) const { return distance(inPlane_(e.from), inPlane_(e.to)); }
  bool isOnFront(Edge e) const {
    return std::find(front_.begin(), front_.end(), e) != front_.end();
  }

  /// Adds an edge to the front, or takes out the opposite one.
  void join(Edge e) {
    const auto opposite = std::find(front_.begin(), front_.end(), Edge{e.to, e.from});
    if (opposite == front_.end())
      front_.push_back(e);
    else
      front_.erase(opposite);
  }

  /// Of those that are free, the one with the best shape.
  std::optional<VertexId> bestApex(Edge base) const {
    struct Apex {
      double shape;
      VertexId vertex;
    };
    std::vector<Apex> apexes;
    for (const Edge& e : front_)
      if (e.from != base.from && e.from != base.to)
        apexes.push_back({shapeOf(base, e.from), e.from});
    std::stable_sort(apexes.begin(), apexes.end(),
                     [](const Apex& a, const Apex& b) { return a.shape > b.shape; });
    for (const Apex& apex : apexes)
      if (isFree(base, apex.vertex)) return apex.vertex;
    return std::nullopt;
  }

  /// Area over squared edges.
  double shapeOf(Edge base, VertexId apex) const {
    const Point2 a = inPlane_(base.from), b = inPlane_(base.to), c = inPlane_(apex);
    return std::abs(cross(b - a, c - a)) /
           (dot(b - a, b - a) + dot(c - b, c - b) + dot(a - c, a - c));
  }

  bool isFree(Edge base, VertexId apex) const {
    const Point2 a = inPlane_(base.from), b = inPlane_(base.to), c = inPlane_(apex);
    if (orientation(a, b, c) != Turn::Left) return false;
    if (isOnFront({base.from, apex}) || isOnFront({apex, base.to})) return false;
    for (const Edge& e : front_) {
      const bool isCorner = e.from == base.from || e.from == base.to || e.from == apex;
      if (!isCorner && holds(a, b, c, inPlane_(e.from))) return false;
      if (crosses({base.from, apex}, e) || crosses({apex, base.to}, e)) return false;
    }
    return true;
  }

  static bool holds(Point2 a, Point2 b, Point2 c, Point2 p) {
    return orientation(a, b, p) != Turn::Right && orientation(b, c, p) != Turn::Right &&
           orientation(c, a, p) != Turn::Right;
  }

  bool crosses(Edge side, Edge e) const {
    if (side.from == e.from || side.from == e.to || side.to == e.from || side.to == e.to)
      return false;
    return segmentsMeet(inPlane_(side.from), inPlane_(side.to), inPlane_(e.from), inPlane_(e.to));
  }

  const std::function<Point2(VertexId)>& inPlane_;
  std::vector<Edge> front_;
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

/// The plane across the mean normal of the vertices that are left on the front.
ProjectionFrame planeOfFront(const MeshingResult& result) {
  Point3 normal;
  for (const StuckEdge& edge : result.stuck)
    normal = normal + result.mesh.vertices[edge.from.value].normal;
  normal = unit(normal);
  ProjectionFrame frame;
  frame.origin = result.mesh.vertices[result.stuck.front().from.value].position;
  const PlaneAxes axes(frame.origin, normal);
  frame.xAxis = axes.xAxis();
  frame.yAxis = axes.yAxis();
  frame.normal = normal;
  return frame;
}

}  // namespace

bool closeFront(MeshingResult& result, const std::function<Point2(VertexId)>& inPlane,
                ElementOrigin origin, std::size_t most) {
  if (result.stuck.empty() || result.stuck.size() > most) return false;
  const auto elements = Closer(result, inPlane).close();
  if (!elements) return false;
  result.mesh.elements.insert(result.mesh.elements.end(), elements->begin(), elements->end());
  result.mesh.origins.insert(result.mesh.origins.end(), elements->size(), origin);
  result.stuck.clear();
  result.outcome = Outcome::Complete;
  return true;
}

bool closeFront(MeshingResult& result, ElementOrigin origin, std::size_t most) {
  if (result.stuck.empty()) return false;
  const ProjectionFrame plane = planeOfFront(result);
  return closeFront(
      result, [&](VertexId v) { return plane.project(result.mesh.vertices[v.value]).position; },
      origin, most);
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
