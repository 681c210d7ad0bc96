// Zones made from shapes.
#include <cmath>
#include <utility>

#include "dsl/shapes/boundary.h"
#include "dsl/shapes/build.h"
#include "dsl/shapes/shape.h"

namespace af2::dsl {
namespace {

class ShapeZone final : public AF2FreeZone {
 public:
  ShapeZone(shapes::Region region, const Box2& box) : region_(std::move(region)), box_(box) {}

  Box2 boundingBox() const override { return box_; }

  bool contains(Point2 point, ZoneBoundary boundary) const override {
    const shapes::Place place = region_.locate(point);
    return place == shapes::Place::In ||
           (place == shapes::Place::On && boundary == ZoneBoundary::Counts);
  }

  bool meets(Point2 from, Point2 to, ZoneBoundary boundary) const override {
    return region_.meets({from, to}, boundary);
  }

 private:
  shapes::Region region_;
  Box2 box_;
};

bool isFinite(const Box2& box) {
  return std::isfinite(box.low.x + box.low.y + box.high.x + box.high.y);
}

}  // namespace

bool isBounded(const Shape& shape) {
  const shapes::Built built = shapes::build(shape);
  return !built.growsWithoutBounds && shapes::isBounded(built.region);
}

MadeZone makeZone(const Shape& shape) {
  if (shape.kind() == ShapeKind::Convex && ConvexPolygonZone::isConvex(shape.points()))
    return {std::make_unique<ConvexPolygonZone>(shape.points())};

  shapes::Built built = shapes::build(shape);
  if (built.refusal != Refusal::None) return {nullptr, built.refusal, built.reason};
  if (built.region.isEmpty()) return {nullptr, Refusal::Shape, "the zone has no area"};
  if (!isFinite(built.box)) {
    if (!shapes::isBounded(built.region))
      return {nullptr, Refusal::Shape, "the zone has no bounds"};
    built.box = shapes::finiteBox(built.region, built.box);
  }
  return {std::make_unique<ShapeZone>(std::move(built.region), built.box)};
}

std::vector<std::vector<Point2>> outline(const Shape& shape, double sag) {
  const shapes::Built built = shapes::build(shape);
  if (built.refusal != Refusal::None || !shapes::isBounded(built.region)) return {};
  const Box2 box = shapes::finiteBox(built.region, built.box);
  return shapes::loopsOf(shapes::boundaryOf(built.region, box), sag);
}

}  // namespace af2::dsl
