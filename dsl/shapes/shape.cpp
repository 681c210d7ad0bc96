#include "dsl/shapes/shape.h"

#include <fmt/format.h>

#include <utility>

namespace af2::dsl {

const char* toString(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::Convex:
      return "corner list";
    case ShapeKind::Poly:
      return "poly";
    case ShapeKind::Disc:
      return "disc";
    case ShapeKind::Left:
      return "left";
    case ShapeKind::Sector:
      return "sector";
    case ShapeKind::Hull:
      return "hull";
    case ShapeKind::Grow:
      return "grow";
    case ShapeKind::Union:
      return "|";
    case ShapeKind::Intersection:
      return "&";
    case ShapeKind::Difference:
      return "-";
    case ShapeKind::User:
      return "registered shape";
  }
  return "shape";
}

Shape::Shape(ShapeKind kind, std::vector<Point2> points, std::vector<double> numbers,
             std::vector<Shape> parts)
    : kind_(kind),
      points_(std::move(points)),
      numbers_(std::move(numbers)),
      parts_(std::move(parts)) {}

Shape Shape::convex(std::vector<Point2> corners) {
  return Shape(ShapeKind::Convex, std::move(corners), {});
}

Shape Shape::poly(std::vector<PathStep> path) {
  Shape shape(ShapeKind::Poly, {}, {});
  for (const PathStep& step : path) {
    if (step.via) shape.points_.push_back(*step.via);
    shape.points_.push_back(step.to);
    shape.arcs_.push_back(step.via.has_value());
  }
  return shape;
}

Shape Shape::disc(Point2 centre, double radius) {
  return Shape(ShapeKind::Disc, {centre}, {radius});
}

Shape Shape::left(Point2 point, Point2 direction) {
  return Shape(ShapeKind::Left, {point, direction}, {});
}

Shape Shape::sector(Point2 centre, double radius, double from, double to) {
  return Shape(ShapeKind::Sector, {centre}, {radius, from, to});
}

Shape Shape::hull(std::vector<Point2> points) {
  return Shape(ShapeKind::Hull, std::move(points), {});
}

Shape Shape::grow(Shape shape, double distance) {
  return Shape(ShapeKind::Grow, {}, {distance}, {std::move(shape)});
}

Shape Shape::user(std::shared_ptr<const AF2FreeZone> zone, Refusal refusal) {
  Shape shape(ShapeKind::User, {}, {});
  shape.zone_ = std::move(zone);
  shape.refusal_ = refusal;
  return shape;
}

Shape operator|(Shape first, Shape second) {
  return Shape(ShapeKind::Union, {}, {}, {std::move(first), std::move(second)});
}

Shape operator&(Shape first, Shape second) {
  return Shape(ShapeKind::Intersection, {}, {}, {std::move(first), std::move(second)});
}

Shape operator-(Shape first, Shape second) {
  return Shape(ShapeKind::Difference, {}, {}, {std::move(first), std::move(second)});
}

std::optional<Shape> fade(const Shape& preferred, const Shape& limiting, double t) {
  if (fadeMismatch(preferred, limiting)) return std::nullopt;

  Shape result = preferred;
  for (std::size_t i = 0; i < result.points_.size(); ++i)
    result.points_[i] = t * preferred.points_[i] + (1 - t) * limiting.points_[i];
  for (std::size_t i = 0; i < result.numbers_.size(); ++i)
    result.numbers_[i] = t * preferred.numbers_[i] + (1 - t) * limiting.numbers_[i];
  for (std::size_t i = 0; i < result.parts_.size(); ++i)
    result.parts_[i] = *fade(preferred.parts_[i], limiting.parts_[i], t);
  return result;
}

std::optional<std::string> fadeMismatch(const Shape& preferred, const Shape& limiting) {
  if (preferred.kind() != limiting.kind())
    return fmt::format("a '{}' cannot fade into a '{}'", toString(preferred.kind()),
                       toString(limiting.kind()));
  if (preferred.arcs() != limiting.arcs() && preferred.arcs().size() == limiting.arcs().size())
    return "a straight step of a 'poly' cannot fade into an arc";
  if (preferred.points().size() != limiting.points().size())
    return fmt::format("a '{}' of {} points cannot fade into one of {}", toString(preferred.kind()),
                       preferred.points().size(), limiting.points().size());
  for (std::size_t i = 0; i < preferred.parts().size(); ++i)
    if (auto mismatch = fadeMismatch(preferred.parts()[i], limiting.parts()[i])) return mismatch;
  return std::nullopt;
}

}  // namespace af2::dsl
