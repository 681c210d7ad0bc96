// Makes zones from shapes.
#include <cmath>
#include <utility>

#include "dsl/shapes/boundary.h"
#include "dsl/shapes/build.h"
#include "dsl/shapes/mixed_zone.h"
#include "dsl/shapes/region_zone.h"
#include "dsl/shapes/shape.h"

namespace af2::dsl {
namespace {

/// The sides between sampled cells inside and outside of the zone, with the inside on their left.
std::vector<shapes::Piece> tracedBoundary(const AF2FreeZone& zone) {
  constexpr int kCells = 100;
  const Box2 box = zone.boundingBox();
  const Point2 cell = (1.0 / kCells) * (box.high - box.low);
  const auto at = [&](int x, int y) { return box.low + Point2{x * cell.x, y * cell.y}; };
  const auto isInside = [&](int x, int y) {
    const Point2 centre = at(x, y) + 0.5 * cell;
    return x >= 0 && y >= 0 && x < kCells && y < kCells &&
           zone.contains(centre, ZoneBoundary::Counts);
  };
  std::vector<shapes::Piece> pieces;
  const auto add = [&](Point2 from, Point2 to) { pieces.push_back({from, to, std::nullopt}); };
  for (int y = 0; y < kCells; ++y)
    for (int x = 0; x < kCells; ++x) {
      if (!isInside(x, y)) continue;
      if (!isInside(x, y - 1)) add(at(x, y), at(x + 1, y));
      if (!isInside(x + 1, y)) add(at(x + 1, y), at(x + 1, y + 1));
      if (!isInside(x, y + 1)) add(at(x + 1, y + 1), at(x, y + 1));
      if (!isInside(x - 1, y)) add(at(x, y + 1), at(x, y));
    }
  return pieces;
}

bool isFinite(const Box2& box) {
  return std::isfinite(box.low.x + box.low.y + box.high.x + box.high.y);
}

}  // namespace

bool isBounded(const Shape& shape) {
  if (shapes::isMixed(shape)) return shapes::isBoundedMixed(shape);
  const shapes::Built built = shapes::build(shape);
  return !built.growsWithoutBounds && shapes::isBounded(built.region);
}

MadeZone makeZone(const Shape& shape) {
  if (shape.kind() == ShapeKind::Convex && ConvexPolygonZone::isConvex(shape.points()))
    return {std::make_unique<ConvexPolygonZone>(shape.points())};
  if (shapes::isMixed(shape)) return shapes::makeMixedZone(shape);

  shapes::Built built = shapes::build(shape);
  if (built.refusal != Refusal::None) return {nullptr, built.refusal, built.reason};
  if (built.region.isEmpty()) return {nullptr, Refusal::Shape, "the zone has no area"};
  if (!isFinite(built.box)) {
    if (!shapes::isBounded(built.region))
      return {nullptr, Refusal::Shape, "the zone has no bounds"};
    built.box = shapes::finiteBox(built.region, built.box);
  }
  return {std::make_unique<shapes::RegionZone>(std::move(built.region), built.box)};
}

std::optional<bool> holds(const Shape& shape, Point2 point) {
  if (shapes::isMixed(shape)) {
    const MadeZone made = shapes::makeMixedZone(shape);
    if (!made.zone) return std::nullopt;
    return made.zone->contains(point, ZoneBoundary::Counts);
  }
  const shapes::Built built = shapes::build(shape);
  if (built.refusal != Refusal::None) return std::nullopt;
  return built.region.locate(point) != shapes::Place::Out;
}

std::vector<std::vector<Point2>> outline(const Shape& shape, double sag) {
  if (shapes::isMixed(shape)) {
    const MadeZone made = shapes::makeMixedZone(shape);
    return made.zone ? outline(*made.zone, sag) : std::vector<std::vector<Point2>>();
  }
  const shapes::Built built = shapes::build(shape);
  if (built.refusal != Refusal::None || !shapes::isBounded(built.region)) return {};
  const Box2 box = shapes::finiteBox(built.region, built.box);
  return shapes::loopsOf(shapes::boundaryOf(built.region, box), sag);
}

std::vector<std::vector<Point2>> outline(const AF2FreeZone& zone, double sag) {
  if (const auto* polygon = dynamic_cast<const ConvexPolygonZone*>(&zone))
    return {{polygon->corners().begin(), polygon->corners().end()}};
  if (const auto* shape = dynamic_cast<const shapes::RegionZone*>(&zone))
    return shapes::loopsOf(shapes::boundaryOf(shape->region(), shape->boundingBox()), sag);
  return shapes::loopsOf(tracedBoundary(zone), sag);
}

}  // namespace af2::dsl
