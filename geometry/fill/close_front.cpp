#include "geometry/fill/close_front.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "engine/base/predicates.h"
#include "geometry/base/constants.h"
#include "geometry/base/disjoint_sets.h"
#include "geometry/base/plane_axes.h"
#include "geometry/fill/drawn_front.h"
#include "geometry/fill/fill_limits.h"

namespace af2::geometry {

namespace {

class Closer {
 public:
  Closer(const std::vector<StuckEdge>& front, const std::function<Point2(VertexId)>& inPlane)
      : front_(verticesOf(front, inPlane)) {
    for (const StuckEdge& edge : front) front_.add({edge.from, edge.to});
  }

  /// Nothing if some edge has no triangle.
  std::optional<std::vector<Element>> close() {
    while (!front_.isEmpty()) {
      const std::size_t i = front_.shortest();
      const Base base{front_.edge(i), front_.from(i), front_.to(i)};
      const std::optional<VertexId> apex = bestApex(base);
      if (!apex) return std::nullopt;
      elements_.push_back({{base.edge.from, base.edge.to, *apex, VertexId()}});
      front_.takeOut(base.edge);
      join({base.edge.from, *apex});
      join({*apex, base.edge.to});
    }
    return std::move(elements_);
  }

 private:
  /// The edge of the front that gets a triangle.
  struct Base {
    DrawnEdge edge;
    Point2 from, to;
  };

  /// A vertex that may become the third corner of a triangle.
  struct Apex {
    double shape;
    std::size_t edge;  ///< of the front, which starts at the vertex

    bool operator<(const Apex& other) const {
      return shape != other.shape ? shape < other.shape : edge > other.edge;
    }
  };

  static std::vector<DrawnFront::Vertex> verticesOf(
      const std::vector<StuckEdge>& front, const std::function<Point2(VertexId)>& inPlane) {
    std::set<VertexId> ids;
    for (const StuckEdge& edge : front) ids.insert({edge.from, edge.to});
    std::vector<DrawnFront::Vertex> vertices;
    for (const VertexId id : ids) vertices.push_back({id, inPlane(id)});
    return vertices;
  }

  /// Whether an edge may not be added. Both sides of an edge may be on the front, as along a path
  /// through its region; then the opposite one is closed.
  bool isTaken(DrawnEdge edge) const {
    return front_.has(edge) && !front_.has({edge.to, edge.from});
  }

  /// Adds an edge to the front, or takes out the opposite one.
  void join(DrawnEdge edge) {
    if (!front_.takeOut({edge.to, edge.from})) front_.add(edge);
  }

  /// Of those that are free, the one with the best shape, and the first of several. They are
  /// looked for near the edge first, and farther away as long as shapes may be better there. Mostly
  /// it is among the best few, so that they are not sorted.
  std::optional<VertexId> bestApex(const Base& base) {
    constexpr double kFirst = 2, kMore = 2;  // edges
    const Point2 middle = 0.5 * (base.from + base.to);
    apexes_.clear();
    DrawnFront::Stretch known = front_.stretchAt(middle, 0);
    known.end = known.begin;  // nothing yet
    for (double reach = kFirst * distance(base.from, base.to);; reach *= kMore) {
      const DrawnFront::Stretch stretch =
          front_.stretchAt(middle, reach > 0 ? reach : std::numeric_limits<double>::infinity());
      addApexes(base, {stretch.begin, known.begin});
      addApexes(base, {known.end, stretch.end});
      known = stretch;
      const bool isAll = front_.isAll(stretch);
      if (const auto apex = bestFree(base, isAll ? -1 : bestShapeBeyond(base, middle, reach)))
        return apex;
      if (isAll) return std::nullopt;
    }
  }

  void addApexes(const Base& base, const DrawnFront::Stretch& stretch) {
    front_.forEachFrom(stretch, [&](std::size_t i) {
      apexes_.push_back({shapeOf(base, front_.from(i)), i});
      std::push_heap(apexes_.begin(), apexes_.end());
      return true;
    });
  }

  /// Takes out of apexes_ those with a better shape than `least`.
  std::optional<VertexId> bestFree(const Base& base, double least) {
    while (!apexes_.empty() && apexes_.front().shape > least) {
      std::pop_heap(apexes_.begin(), apexes_.end());
      const std::size_t best = apexes_.back().edge;
      apexes_.pop_back();
      const VertexId apex = front_.edge(best).from;
      if (apex == base.edge.from || apex == base.edge.to) continue;
      if (isFree(base, apex, front_.from(best))) return apex;
    }
    return std::nullopt;
  }

  /// An upper bound for corners that are more than `reach` away from the middle of the edge, which
  /// is longer than the edge: the squares of the sides at a distance d are those of the edge, half
  /// as much, and 2 d d.
  double bestShapeBeyond(const Base& base, Point2 middle, double reach) const {
    const Point2 way = base.to - base.from;
    const double area = std::abs(front_.along(way)) * front_.farthestAcross(middle) +
                        std::abs(front_.across(way)) * reach;
    return kMoreThanRounding * area / (1.5 * dot(way, way) + 2 * reach * reach);
  }

  /// Area over squared edges.
  static double shapeOf(const Base& base, Point2 c) {
    const Point2 a = base.from, b = base.to;
    return std::abs(cross(b - a, c - a)) /
           (dot(b - a, b - a) + dot(c - b, c - b) + dot(a - c, a - c));
  }

  bool isFree(const Base& base, VertexId apex, Point2 c) const {
    const Point2 a = base.from, b = base.to;
    if (orientation(a, b, c) != Turn::Left) return false;
    const Base left{{base.edge.from, apex}, a, c}, right{{apex, base.edge.to}, c, b};
    if (isTaken(left.edge) || isTaken(right.edge)) return false;
    return front_.forEachNear(a, b, c, [&](std::size_t i) {
      const Point2 from = front_.from(i), to = front_.to(i);
      if (areRightOf(a, b, from, to) || areRightOf(b, c, from, to) || areRightOf(c, a, from, to))
        return true;
      const DrawnEdge e = front_.edge(i);
      const bool isCorner = e.from == base.edge.from || e.from == base.edge.to || e.from == apex;
      return (isCorner || !holds(a, b, c, from)) && !crosses(left, e, from, to) &&
             !crosses(right, e, from, to);
    });
  }

  static bool areRightOf(Point2 a, Point2 b, Point2 p, Point2 q) {
    return orientation(a, b, p) == Turn::Right && orientation(a, b, q) == Turn::Right;
  }

  static bool holds(Point2 a, Point2 b, Point2 c, Point2 p) {
    return orientation(a, b, p) != Turn::Right && orientation(b, c, p) != Turn::Right &&
           orientation(c, a, p) != Turn::Right;
  }

  static bool crosses(const Base& side, DrawnEdge e, Point2 from, Point2 to) {
    const auto isEnd = [&](VertexId v) { return v == e.from || v == e.to; };
    return !isEnd(side.edge.from) && !isEnd(side.edge.to) &&
           segmentsMeet(side.from, side.to, from, to);
  }

  DrawnFront front_;
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
