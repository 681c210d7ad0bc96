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

/// The edges of a front in the plane, in the order in which they were added. What is looked at for
/// all of them lies side by side.
class DrawnFront {
 public:
  std::size_t size() const { return edges_.size(); }  ///< with those that were taken out
  bool isEmpty() const { return byLength_.empty(); }
  bool has(std::size_t i) const { return isOn_[i]; }
  Edge edge(std::size_t i) const { return edges_[i]; }
  Point2 from(std::size_t i) const { return from_[i]; }
  Point2 to(std::size_t i) const { return to_[i]; }
  const Box& box(std::size_t i) const { return boxes_[i]; }
  std::size_t shortest() const { return index_.at(byLength_.begin()->second); }
  bool has(Edge edge) const { return index_.contains(edge); }

  void add(Edge edge, Point2 from, Point2 to) {
    if (!index_.emplace(edge, edges_.size()).second) return;
    byLength_.emplace(distance(from, to), edge);
    edges_.push_back(edge);
    from_.push_back(from);
    to_.push_back(to);
    boxes_.push_back(Box::of(from, to));
    isOn_.push_back(true);
  }

  /// Returns whether the edge was there.
  bool takeOut(Edge edge) {
    const auto found = index_.find(edge);
    if (found == index_.end()) return false;
    const std::size_t i = found->second;
    byLength_.erase({distance(from_[i], to_[i]), edge});
    index_.erase(found);
    isOn_[i] = false;
    boxes_[i] = kNowhere;
    if (edges_.size() > 2 * index_.size() + kFew) forgetTakenOut();
    return true;
  }

 private:
  static constexpr std::size_t kFew = 16;
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  static constexpr Box kNowhere{{kFar, kFar}, {-kFar, -kFar}};

  void forgetTakenOut() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (!isOn_[i]) continue;
      edges_[kept] = edges_[i];
      from_[kept] = from_[i];
      to_[kept] = to_[i];
      boxes_[kept] = boxes_[i];
      index_.at(edges_[i]) = kept++;
    }
    edges_.resize(kept);
    from_.resize(kept);
    to_.resize(kept);
    boxes_.resize(kept);
    isOn_.assign(kept, true);
  }

  std::vector<Edge> edges_;
  std::vector<Point2> from_, to_;
  std::vector<Box> boxes_;
  std::vector<bool> isOn_;
  std::map<Edge, std::size_t> index_;
  std::set<std::pair<double, Edge>> byLength_;
};

class Closer {
 public:
  Closer(const std::vector<StuckEdge>& front, const std::function<Point2(VertexId)>& inPlane)
      : inPlane_(inPlane) {
    for (const StuckEdge& edge : front) add({edge.from, edge.to});
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
    Edge edge;
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

  void add(Edge edge) { front_.add(edge, inPlane_(edge.from), inPlane_(edge.to)); }

  /// Whether an edge may not be added. Both sides of an edge may be on the front, as along a path
  /// through its region; then the opposite one is closed.
  bool isTaken(Edge edge) const { return front_.has(edge) && !front_.has({edge.to, edge.from}); }

  /// Adds an edge to the front, or takes out the opposite one.
  void join(Edge edge) {
    if (!front_.takeOut({edge.to, edge.from})) add(edge);
  }

  /// Of those that are free, the one with the best shape, and the first of several. Mostly it is
  /// among the best few, so that they are not sorted.
  std::optional<VertexId> bestApex(const Base& base) {
    apexes_.clear();
    for (std::size_t i = 0; i < front_.size(); ++i)
      if (front_.has(i)) apexes_.push_back({shapeOf(base, front_.from(i)), i});
    std::make_heap(apexes_.begin(), apexes_.end());
    for (auto end = apexes_.end(); end != apexes_.begin(); --end) {
      std::pop_heap(apexes_.begin(), end);
      const std::size_t best = (end - 1)->edge;
      const VertexId apex = front_.edge(best).from;
      if (apex == base.edge.from || apex == base.edge.to) continue;
      if (isFree(base, apex, front_.from(best))) return apex;
    }
    return std::nullopt;
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
    const Box triangle{{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
                       {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}};
    for (std::size_t i = 0; i < front_.size(); ++i) {
      // Most edges are beside the triangle; the tests below would say so, too, but later.
      if (triangle.isApartFrom(front_.box(i))) continue;
      const Point2 from = front_.from(i), to = front_.to(i);
      if (areRightOf(a, b, from, to) || areRightOf(b, c, from, to) || areRightOf(c, a, from, to))
        continue;
      const Edge e = front_.edge(i);
      const bool isCorner = e.from == base.edge.from || e.from == base.edge.to || e.from == apex;
      if (!isCorner && holds(a, b, c, from)) return false;
      if (crosses(left, e, from, to) || crosses(right, e, from, to)) return false;
    }
    return true;
  }

  static bool areRightOf(Point2 a, Point2 b, Point2 p, Point2 q) {
    return orientation(a, b, p) == Turn::Right && orientation(a, b, q) == Turn::Right;
  }

  static bool holds(Point2 a, Point2 b, Point2 c, Point2 p) {
    return orientation(a, b, p) != Turn::Right && orientation(b, c, p) != Turn::Right &&
           orientation(c, a, p) != Turn::Right;
  }

  static bool crosses(const Base& side, Edge e, Point2 from, Point2 to) {
    const auto isEnd = [&](VertexId v) { return v == e.from || v == e.to; };
    return !isEnd(side.edge.from) && !isEnd(side.edge.to) &&
           segmentsMeet(side.from, side.to, from, to);
  }

  const std::function<Point2(VertexId)>& inPlane_;
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
