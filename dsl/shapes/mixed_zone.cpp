#include "dsl/shapes/mixed_zone.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dsl/shapes/build.h"
#include "dsl/shapes/covering_zone.h"
#include "dsl/shapes/region_zone.h"

namespace af2::dsl::shapes {
namespace {

bool isOutside(const Box2& box, Point2 p, Point2 q) {
  return std::max(p.x, q.x) < box.low.x || std::min(p.x, q.x) > box.high.x ||
         std::max(p.y, q.y) < box.low.y || std::min(p.y, q.y) > box.high.y;
}

/// A set whose queries are answered by its parts.
struct Part {
  Operation operation = Operation::Leaf;
  std::shared_ptr<const AF2FreeZone> zone;  ///< for a leaf; null for the empty set
  Box2 box;
  std::vector<Part> parts;  ///< two parts; none for a leaf

  bool contains(Point2 p, ZoneBoundary boundary) const {
    const auto other =
        boundary == ZoneBoundary::Counts ? ZoneBoundary::Ignored : ZoneBoundary::Counts;
    switch (operation) {
      case Operation::Union:
        return parts[0].contains(p, boundary) || parts[1].contains(p, boundary);
      case Operation::Intersection:
        return parts[0].contains(p, boundary) && parts[1].contains(p, boundary);
      case Operation::Difference:
        return parts[0].contains(p, boundary) && !parts[1].contains(p, other);
      default:
        return zone && !isOutside(box, p, p) && zone->contains(p, boundary);
    }
  }

  /// Whether the closed set is known to contain the whole edge.
  bool covers(Point2 p, Point2 q) const {
    switch (operation) {
      case Operation::Union:
        return parts[0].covers(p, q) || parts[1].covers(p, q);
      case Operation::Intersection:
        return parts[0].covers(p, q) && parts[1].covers(p, q);
      case Operation::Difference:
        return parts[0].covers(p, q) && !parts[1].mayMeet(p, q, ZoneBoundary::Ignored);
      default:
        return zone && !isOutside(box, p, q) && dsl::covers(*zone, p, q);
    }
  }

  /// False if the edge is known not to meet the set.
  bool mayMeet(Point2 p, Point2 q, ZoneBoundary boundary) const {
    switch (operation) {
      case Operation::Union:
        return parts[0].mayMeet(p, q, boundary) || parts[1].mayMeet(p, q, boundary);
      case Operation::Intersection:
        return parts[0].mayMeet(p, q, boundary) && parts[1].mayMeet(p, q, boundary);
      case Operation::Difference:
        return parts[0].mayMeet(p, q, boundary) && !parts[1].covers(p, q);
      default:
        return zone && !isOutside(box, p, q) && zone->meets(p, q, boundary);
    }
  }

  bool meets(Point2 p, Point2 q, ZoneBoundary boundary, int halvings) const {
    if (!mayMeet(p, q, boundary)) return false;
    if (operation == Operation::Leaf) return true;
    if (operation == Operation::Union)
      return parts[0].meets(p, q, boundary, halvings) || parts[1].meets(p, q, boundary, halvings);
    const Point2 middle = p + 0.5 * (q - p);
    if (halvings == 0 || contains(middle, boundary)) return true;
    return meets(p, middle, boundary, halvings - 1) || meets(middle, q, boundary, halvings - 1);
  }
};

class MixedZone final : public CoveringZone {
 public:
  explicit MixedZone(Part whole) : whole_(std::move(whole)) {}

  Box2 boundingBox() const override { return whole_.box; }
  bool contains(Point2 point, ZoneBoundary boundary) const override {
    return whole_.contains(point, boundary);
  }
  bool meets(Point2 from, Point2 to, ZoneBoundary boundary) const override {
    constexpr int kHalvings = 30;
    return from == to ? whole_.contains(from, boundary)
                      : whole_.meets(from, to, boundary, kHalvings);
  }
  bool covers(Point2 from, Point2 to) const override { return whole_.covers(from, to); }

 private:
  Part whole_;
};

Operation operationOf(ShapeKind kind) {
  return kind == ShapeKind::Union          ? Operation::Union
         : kind == ShapeKind::Intersection ? Operation::Intersection
                                           : Operation::Difference;
}

Box2 boxOf(Operation operation, const Box2& p, const Box2& q) {
  if (operation == Operation::Difference) return p;
  if (operation == Operation::Union)
    return {{std::min(p.low.x, q.low.x), std::min(p.low.y, q.low.y)},
            {std::max(p.high.x, q.high.x), std::max(p.high.y, q.high.y)}};
  return {{std::max(p.low.x, q.low.x), std::max(p.low.y, q.low.y)},
          {std::min(p.high.x, q.high.x), std::min(p.high.y, q.high.y)}};
}

/// Reorders unions and intersections so that parts without registered shapes come first and are
/// merged. Seams between these parts are then inner seams.
Shape regrouped(const Shape& shape) {
  const bool isChain = shape.kind() == ShapeKind::Union || shape.kind() == ShapeKind::Intersection;
  if (!isChain || !isMixed(shape)) return shape;
  std::vector<Shape> operands{shape}, plain, mixed;
  while (!operands.empty()) {
    const Shape one = operands.back();
    operands.pop_back();
    if (one.kind() == shape.kind()) {
      operands.push_back(one.parts()[1]);
      operands.push_back(one.parts()[0]);
    } else {
      (isMixed(one) ? mixed : plain).push_back(one);
    }
  }
  plain.insert(plain.end(), mixed.begin(), mixed.end());
  Shape result = plain[0];
  for (std::size_t i = 1; i < plain.size(); ++i)
    result = shape.kind() == ShapeKind::Union ? std::move(result) | std::move(plain[i])
                                              : std::move(result) & std::move(plain[i]);
  return result;
}

/// Builds parts from the bottom up; `refused` is set if a part is invalid.
class Builder {
 public:
  MadeZone refused{nullptr, Refusal::None, ""};

  Part partOf(const Shape& given) {
    if (given.kind() == ShapeKind::User) return leafOf(given.zone(), given.refusal());
    if (!isMixed(given)) return regionOf(given);
    const Shape shape = regrouped(given);
    Part part;
    part.operation = operationOf(shape.kind());
    for (const Shape& one : shape.parts()) part.parts.push_back(partOf(one));
    part.box = boxOf(part.operation, part.parts[0].box, part.parts[1].box);
    return part;
  }

 private:
  Part leafOf(std::shared_ptr<const AF2FreeZone> zone, Refusal refusal) {
    if (!zone) {
      if (refused.refusal == Refusal::None)
        refused = {nullptr, refusal == Refusal::None ? Refusal::Shape : refusal,
                   "a registered shape has no form"};
      return {};
    }
    const Box2 box = zone->boundingBox();
    return {Operation::Leaf, std::move(zone), box, {}};
  }

  Part regionOf(const Shape& shape) {
    Built built = build(shape);
    if (built.refusal != Refusal::None) {
      if (refused.refusal == Refusal::None) refused = {nullptr, built.refusal, built.reason};
      return {};
    }
    if (built.region.isEmpty())
      return {Operation::Leaf, nullptr, {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}}, {}};
    if (isBounded(built.region)) built.box = finiteBox(built.region, built.box);
    return leafOf(std::make_shared<const RegionZone>(std::move(built.region), built.box),
                  Refusal::None);
  }
};

bool isFinite(const Box2& box) {
  return std::isfinite(box.low.x + box.low.y + box.high.x + box.high.y);
}

}  // namespace

bool isMixed(const Shape& shape) {
  return shape.kind() == ShapeKind::User || std::ranges::any_of(shape.parts(), isMixed);
}

bool isBoundedMixed(const Shape& shape) {
  switch (shape.kind()) {
    case ShapeKind::User:
      return true;
    case ShapeKind::Union:
      return isBounded(shape.parts()[0]) && isBounded(shape.parts()[1]);
    case ShapeKind::Intersection:
      return isBounded(shape.parts()[0]) || isBounded(shape.parts()[1]);
    default:
      return isBounded(shape.parts()[0]);
  }
}

MadeZone makeMixedZone(const Shape& shape) {
  Builder builder;
  Part whole = builder.partOf(shape);
  if (builder.refused.refusal != Refusal::None) return std::move(builder.refused);
  if (shape.kind() != ShapeKind::User && !isFinite(whole.box)) {
    const bool isEmpty = whole.box.low.x > whole.box.high.x;
    return {nullptr, Refusal::Shape, isEmpty ? "the zone has no area" : "the zone has no bounds"};
  }
  return {std::make_unique<MixedZone>(std::move(whole))};
}

}  // namespace af2::dsl::shapes

bool af2::dsl::covers(const AF2FreeZone& zone, Point2 from, Point2 to) {
  if (const auto* covering = dynamic_cast<const CoveringZone*>(&zone))
    return covering->covers(from, to);
  return dynamic_cast<const ConvexPolygonZone*>(&zone) &&
         zone.contains(from, ZoneBoundary::Counts) && zone.contains(to, ZoneBoundary::Counts);
}
