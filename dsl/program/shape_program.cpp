#include "dsl/program/shape_program.h"

#include <limits>

#include "dsl/program/registry.h"
#include "dsl/shapes/covering_zone.h"
#include "engine/base/error.h"

namespace af2::dsl {
namespace {

/// The numbers of a shape, in the order in which `build` reads them.
void collect(const ShapeValue& shape, std::vector<Node>& nodes) {
  for (NodePair p : shape.points) {
    nodes.push_back(p.x);
    nodes.push_back(p.y);
  }
  nodes.insert(nodes.end(), shape.numbers.begin(), shape.numbers.end());
  for (const auto& part : shape.parts) collect(*part, nodes);
}

Program programOf(const ProgramBuilder& builder, const ShapeValue& shape) {
  std::vector<Node> nodes;
  collect(shape, nodes);
  return builder.program(nodes);
}

std::vector<PathStep> pathOf(const std::vector<Point2>& points, const std::vector<bool>& arcs) {
  std::vector<PathStep> path;
  std::size_t next = 0;
  for (bool isArc : arcs) {
    PathStep step;
    if (isArc) step.via = points[next++];
    step.to = points[next++];
    path.push_back(step);
  }
  return path;
}

/// Any zone, reflected in the line x = ends / 2.
class ReflectedZone final : public CoveringZone {
 public:
  ReflectedZone(std::shared_ptr<const AF2FreeZone> zone, double ends)
      : zone_(std::move(zone)), ends_(ends) {}
  Box2 boundingBox() const override {
    const Box2 box = zone_->boundingBox();
    return {{ends_ - box.high.x, box.low.y}, {ends_ - box.low.x, box.high.y}};
  }
  bool contains(Point2 p, ZoneBoundary boundary) const override {
    return zone_->contains(reflected(p), boundary);
  }
  bool meets(Point2 from, Point2 to, ZoneBoundary boundary) const override {
    return zone_->meets(reflected(from), reflected(to), boundary);
  }
  bool covers(Point2 from, Point2 to) const override {
    return dsl::covers(*zone_, reflected(from), reflected(to));
  }

 private:
  Point2 reflected(Point2 p) const { return {ends_ - p.x, p.y}; }

  std::shared_ptr<const AF2FreeZone> zone_;
  double ends_;
};

Shape userShape(const ShapeValue& shape, const AF2Binding& binding,
                std::span<const double> numbers) {
  AF2FreeZoneDef::Made made = shape.user->make(numbers);
  std::shared_ptr<const AF2FreeZone> zone = std::move(made.zone);
  if (zone && shape.isReflected)
    zone = std::make_shared<const ReflectedZone>(std::move(zone), binding.vertices[1].x);
  return Shape::user(std::move(zone), made.refusal);
}

}  // namespace

ShapeProgram::ShapeProgram(const ProgramBuilder& builder, const ShapeValue& shape)
    : shape_(shape), program_(programOf(builder, shape)) {}

Shape ShapeProgram::build(const ShapeValue& shape, const AF2Binding& binding,
                          std::span<const double> numbers, std::size_t& next) const {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < shape.points.size(); ++i, next += 2)
    points.push_back({numbers[next], numbers[next + 1]});
  std::vector<double> own;
  for (std::size_t i = 0; i < shape.numbers.size(); ++i) own.push_back(numbers[next++]);
  std::vector<Shape> parts;
  for (const auto& part : shape.parts) parts.push_back(build(*part, binding, numbers, next));
  switch (shape.kind) {
    case ShapeKind::Convex:
      return Shape::convex(std::move(points));
    case ShapeKind::Poly:
      return Shape::poly(pathOf(points, shape.arcs));
    case ShapeKind::Disc:
      return Shape::disc(points[0], own[0]);
    case ShapeKind::Left:
      return Shape::left(points[0], points[1]);
    case ShapeKind::Sector:
      return Shape::sector(points[0], own[0], own[1], own[2]);
    case ShapeKind::Hull:
      return Shape::hull(std::move(points));
    case ShapeKind::Grow:
      return Shape::grow(std::move(parts[0]), own[0]);
    case ShapeKind::Union:
      return std::move(parts[0]) | std::move(parts[1]);
    case ShapeKind::Intersection:
      return std::move(parts[0]) & std::move(parts[1]);
    case ShapeKind::Difference:
      return std::move(parts[0]) - std::move(parts[1]);
    case ShapeKind::User:
      return userShape(shape, binding, own);
  }
  throw InternalError("unknown kind of shape");
}

std::optional<Shape> ShapeProgram::shapeAt(const AF2Binding& binding) const {
  std::vector<double> numbers(program_.resultCount());
  if (!program_.run(binding, {}, numbers)) return std::nullopt;
  std::size_t next = 0;
  return build(shape_, binding, numbers, next);
}

double ShapeProgram::holds(const AF2Binding& binding, Point2 point) const {
  const auto shape = shapeAt(binding);
  const auto holds = shape ? af2::dsl::holds(*shape, point) : std::nullopt;
  return holds ? (*holds ? 1 : 0) : std::numeric_limits<double>::quiet_NaN();
}

ShapeZoneDef::ShapeZoneDef(std::vector<Alternative> alternatives,
                           std::vector<std::int8_t> cornerVertices)
    : alternatives_(std::move(alternatives)), cornerVertices_(std::move(cornerVertices)) {
  if (alternatives_.empty()) throw InputError("free zone: no shape is given");
}

std::optional<Shape> ShapeZoneDef::shapeAt(const AF2Binding& binding) const {
  for (const Alternative& alternative : alternatives_) {
    if (alternative.when) {
      const auto holds = alternative.when->evaluate(binding);
      if (!holds) return std::nullopt;
      if (*holds == 0) continue;
    }
    return alternative.shape->shapeAt(binding);
  }
  return std::nullopt;
}

AF2FreeZoneDef::Made ShapeZoneDef::makeFreeZone(const AF2Binding& binding) const {
  for (const Alternative& alternative : alternatives_) {
    if (alternative.when) {
      const auto holds = alternative.when->evaluate(binding);
      if (!holds) return {nullptr, Refusal::NoValue};
      if (*holds == 0) continue;
    }
    const auto shape = alternative.shape->shapeAt(binding);
    if (!shape) return {nullptr, Refusal::NoValue};
    MadeZone made = makeZone(*shape);
    return {std::move(made.zone), made.refusal};
  }
  return {nullptr, Refusal::Shape};
}

}  // namespace af2::dsl
