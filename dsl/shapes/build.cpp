#include "dsl/shapes/build.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dsl/shapes/arc.h"
#include "dsl/shapes/boundary.h"
#include "dsl/shapes/path.h"
#include "engine/base/elementary.h"
#include "engine/base/predicates.h"

namespace af2::dsl::shapes {
namespace {

constexpr Box2 kNowhere{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
constexpr Box2 kEverywhere{{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};

Box2 join(const Box2& p, const Box2& q) {
  return {{std::min(p.low.x, q.low.x), std::min(p.low.y, q.low.y)},
          {std::max(p.high.x, q.high.x), std::max(p.high.y, q.high.y)}};
}

Box2 meet(const Box2& p, const Box2& q) {
  return {{std::max(p.low.x, q.low.x), std::max(p.low.y, q.low.y)},
          {std::min(p.high.x, q.high.x), std::min(p.high.y, q.high.y)}};
}

Built refused(Refusal refusal, const char* reason) {
  return {{}, kNowhere, refusal, reason, false};
}
Built nothing() { return {{}, kNowhere, Refusal::None, "", false}; }

Built only(Leaf leaf) {
  const Box2 box = leaf.box;
  return {Region(std::move(leaf)), box};
}

Built combine(Built first, Operation operation, Built second) {
  if (first.refusal != Refusal::None) return first;
  if (second.refusal != Refusal::None) return second;
  const Box2 box = operation == Operation::Intersection ? meet(first.box, second.box)
                   : operation == Operation::Difference ? first.box
                                                        : join(first.box, second.box);
  return {Region(std::move(first.region), operation, std::move(second.region)), box};
}

/// Whether products of four such numbers are finite; the predicates compute such products.
bool isUsable(double x) {
  constexpr double kLargest = 1e75;
  return std::abs(x) <= kLargest;
}
bool isUsable(Point2 p) { return isUsable(p.x) && isUsable(p.y); }

bool isUsable(const Shape& shape) {
  return std::ranges::all_of(shape.points(), [](Point2 p) { return isUsable(p); }) &&
         std::ranges::all_of(shape.numbers(), [](double x) { return isUsable(x); });
}

Built refusedNumber() { return refused(Refusal::NoValue, "a number is not finite or too large"); }

// --- discs and half planes

Built buildDisc(Point2 centre, double radius) {
  if (radius < 0) return refused(Refusal::Shape, "a radius is negative");
  return radius == 0 ? nothing() : only(makeLeaf(Disc{centre, radius}));
}

Built halfPlane(Point2 point, Point2 direction) {
  if (!isUsable(point)) return refusedNumber();
  return only(makeLeaf(HalfPlane{point, {0, 0}, direction}));
}

Built buildLeft(const Shape& shape) {
  const Point2 direction = shape.points()[1];
  if (direction == Point2{}) return refused(Refusal::NoValue, "a half plane has no direction");
  return halfPlane(shape.points()[0], direction);
}

/// Quarter turns are exact, so that the flanks of a quadrant are parallel to the axes.
Point2 directionAt(double angle) {
  const double quarters = angle / (M_PI / 2);
  const double nearest = std::round(quarters);
  if (std::abs(quarters - nearest) > 1e-15 * std::max(1.0, std::abs(nearest)))
    return af2::directionAt(angle);
  const int quarter = static_cast<int>(nearest - 4 * std::floor(nearest / 4));
  constexpr Point2 kDirections[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  return kDirections[quarter];
}

/// The sector between two directions, counter-clockwise; `isWide` if it exceeds a half turn.
Built wedge(Point2 apex, Point2 from, Point2 to, bool isWide) {
  return combine(halfPlane(apex, from), isWide ? Operation::Union : Operation::Intersection,
                 halfPlane(apex, {-to.x, -to.y}));
}

Built buildSector(Point2 centre, double radius, double from, double to) {
  double sweep = to - from;
  if (sweep < 0) sweep += 2 * M_PI * std::ceil(-sweep / (2 * M_PI));
  if (sweep == 0) return radius < 0 ? buildDisc(centre, radius) : nothing();
  Built disc = buildDisc(centre, radius);
  if (sweep >= 2 * M_PI) return disc;
  return combine(std::move(disc), Operation::Intersection,
                 wedge(centre, directionAt(from), directionAt(to), sweep > M_PI));
}

// --- polygons and paths

Built buildPolygon(std::vector<Point2> corners) {
  return corners.size() < 3 ? nothing() : only(makeLeaf(Polygon{std::move(corners)}));
}

Built buildConvex(const Shape& shape) {
  if (!ConvexPolygonZone::isConvex(shape.points()))
    return refused(Refusal::Convexity,
                   "the corners do not run counter-clockwise around a convex region");
  const ConvexPolygonZone zone(shape.points());
  return buildPolygon({zone.corners().begin(), zone.corners().end()});
}

/// The polygon of the chords by the even-odd rule, combined with each piece between an arc and its
/// chord. A point is inside the path if an odd number of these sets contain it.
Built buildPoly(const Shape& shape) {
  const auto path = stepsOf(shape);
  if (!path)
    return refused(Refusal::Shape, "an arc's three points lie on a line in the wrong order");
  if (!isSimple(*path)) return refused(Refusal::Shape, "the path crosses or touches itself");
  if (windingOf(*path) <= 0)
    return refused(Refusal::Shape, "the path does not run counter-clockwise around an area");

  std::vector<Point2> corners;
  for (const Step& step : *path) corners.push_back(step.from);
  Built built = only(makeLeaf(Polygon{std::move(corners)}));
  for (const Step& step : *path) {
    if (!step.via) continue;
    Built piece = combine(only(makeLeaf(circleOf(step))), Operation::Intersection,
                          only(makeLeaf(chordOf(step))));
    piece.box = boxOf(step);
    built = combine(std::move(built), Operation::Xor, std::move(piece));
  }
  return built;
}

bool comesBefore(Point2 p, Point2 q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

/// Convex hull, counter-clockwise, without straight corners. Source: [Andrew79].
std::vector<Point2> hullOf(std::vector<Point2> points) {
  std::sort(points.begin(), points.end(), comesBefore);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;

  std::vector<Point2> hull;
  const auto addChain = [&hull](auto begin, auto end) {
    const std::size_t start = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= start + 2 &&
             orientation(hull[hull.size() - 2], hull.back(), *p) != Turn::Left)
        hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // this point begins the other chain
  };
  addChain(points.begin(), points.end());
  addChain(points.rbegin(), points.rend());
  return hull;
}

// --- grow

/// All points within `distance` of a piece of boundary.
Built grownPiece(const Piece& piece, double distance) {
  if (!piece.arc) {
    const Point2 along = piece.to - piece.from;
    const double size = length(along);
    if (size == 0) return nothing();
    const Point2 out = (distance / size) * Point2{along.y, -along.x};
    return buildPolygon({piece.from, piece.from + out, piece.to + out, piece.to});
  }
  const Disc& circle = piece.arc->circle;
  Built ring = buildDisc(circle.centre, circle.radius + distance);
  if (distance < circle.radius)
    ring = combine(std::move(ring), Operation::Difference,
                   buildDisc(circle.centre, circle.radius - distance));
  if (piece.from == piece.to) return ring;
  const Point2 p = piece.from - circle.centre, q = piece.to - circle.centre;
  const double sweep = piece.arc->sweep;
  return combine(std::move(ring), Operation::Intersection,
                 sweep > 0 ? wedge(circle.centre, p, q, sweep > M_PI)
                           : wedge(circle.centre, q, p, -sweep > M_PI));
}

Built grownAlong(Built inner, const std::vector<Piece>& boundary, double distance) {
  std::vector<Point2> ends;
  for (const Piece& piece : boundary) {
    inner = combine(std::move(inner), Operation::Union, grownPiece(piece, distance));
    ends.push_back(piece.from);
    ends.push_back(piece.to);
  }
  std::sort(ends.begin(), ends.end(), comesBefore);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (const Point2 end : ends)
    inner = combine(std::move(inner), Operation::Union, buildDisc(end, distance));
  return inner;
}

/// The sides of a closed polygon; for a single point, the point itself.
std::vector<Piece> sidesOf(std::span<const Point2> corners) {
  std::vector<Piece> sides;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sides.push_back({corners[i], corners[(i + 1) % corners.size()], std::nullopt});
  return sides;
}

std::optional<std::vector<Point2>> straightCorners(const Shape& shape) {
  if (shape.kind() == ShapeKind::Hull) return hullOf(shape.points());
  if (shape.kind() == ShapeKind::Convex) return shape.points();
  const auto isArc = [](bool arc) { return arc; };
  if (shape.kind() != ShapeKind::Poly ||
      std::any_of(shape.arcs().begin(), shape.arcs().end(), isArc))
    return std::nullopt;
  return shape.points();
}

Built buildGrown(const Shape& shape, double distance) {
  const auto& points = shape.points();
  const auto& numbers = shape.numbers();
  if (shape.kind() == ShapeKind::Union)
    return combine(buildGrown(shape.parts()[0], distance), Operation::Union,
                   buildGrown(shape.parts()[1], distance));
  if (shape.kind() == ShapeKind::Grow) {
    if (!isUsable(shape) || numbers[0] < 0) return build(shape);
    return buildGrown(shape.parts()[0], numbers[0] + distance);
  }

  Built inner = build(shape);
  if (inner.refusal != Refusal::None || distance == 0) return inner;
  if (shape.kind() == ShapeKind::Disc) return buildDisc(points[0], numbers[0] + distance);
  if (shape.kind() == ShapeKind::Left) {
    const Point2 v = points[1];
    return halfPlane(points[0] + (distance / length(v)) * Point2{v.y, -v.x}, v);
  }
  if (const auto corners = straightCorners(shape))
    return grownAlong(std::move(inner), sidesOf(*corners), distance);
  if (!isBounded(inner.region))
    return {{}, kNowhere, Refusal::Shape, "the shape in `grow` has no bounds", true};
  const auto boundary = boundaryOf(inner.region, finiteBox(inner.region, inner.box));
  return grownAlong(std::move(inner), boundary, distance);
}

}  // namespace

Built build(const Shape& shape) {
  if (!isUsable(shape)) return refusedNumber();
  const auto& points = shape.points();
  const auto& numbers = shape.numbers();
  const auto part = [&shape](int i) { return build(shape.parts()[i]); };
  switch (shape.kind()) {
    case ShapeKind::Convex:
      return buildConvex(shape);
    case ShapeKind::Poly:
      return buildPoly(shape);
    case ShapeKind::Disc:
      return buildDisc(points[0], numbers[0]);
    case ShapeKind::Left:
      return buildLeft(shape);
    case ShapeKind::Sector:
      return buildSector(points[0], numbers[0], numbers[1], numbers[2]);
    case ShapeKind::Hull:
      return buildPolygon(hullOf(points));
    case ShapeKind::Grow:
      if (numbers[0] < 0) return refused(Refusal::Shape, "a distance to grow by is negative");
      return buildGrown(shape.parts()[0], numbers[0]);
    case ShapeKind::Union:
      return combine(part(0), Operation::Union, part(1));
    case ShapeKind::Intersection:
      return combine(part(0), Operation::Intersection, part(1));
    case ShapeKind::Difference:
      return combine(part(0), Operation::Difference, part(1));
    case ShapeKind::User:
      return refused(Refusal::Shape, "a registered shape is not a region");
  }
  return nothing();
}

}  // namespace af2::dsl::shapes
