#include "dsl/compile/type_help.h"

namespace af2::dsl {
namespace {

std::string wayToNumber(const Value& found) {
  if (found.type == Type::Angle) return "divide it by another angle, as in turn(b)/90deg";
  if (found.type == Type::Truth) return "write `if condition then 1 else 0`";
  if (found.isVector()) return "its length is len(v), its coordinates are v.x and v.y";
  if (found.type == Type::Geometric)
    return "its coordinates are p.x and p.y, its distance from another point is dist(p, q)";
  return {};
}

}  // namespace

Wanted wantedNumber() { return {Wanted::Kind::Number, "a number"}; }
Wanted wantedAngle() { return {Wanted::Kind::Angle, "an angle"}; }
Wanted wantedCondition() { return {Wanted::Kind::Condition, "a condition"}; }
Wanted wantedPoint() { return {Wanted::Kind::Point, "a point"}; }
Wanted wantedShape() { return {Wanted::Kind::Shape, "a shape"}; }

Wanted wantedBy(char parameter) {
  switch (parameter) {
    case 'n':
      return wantedNumber();
    case 'a':
    case 'r':
      return wantedAngle();
    case 'x':
      return {Wanted::Kind::Number, "a number or an angle"};
    case 'p':
      return wantedPoint();
    case 'v':
      return {Wanted::Kind::Vector, "a vector"};
    case 'g':
      return {Wanted::Kind::Point, "a point or a vector"};
    case 'l':
      return {Wanted::Kind::Point, "a point, a vector or a number"};
    case 't':
      return wantedCondition();
    case 'w':
      return {Wanted::Kind::Other, "a vertex of the front"};
    case 'c':
      return {Wanted::Kind::Other, "a vertex of a chain"};
    case 'e':
      return {Wanted::Kind::Other, "an end of the base edge, a or b"};
    default:
      return {Wanted::Kind::Other, "a value"};
  }
}

std::string wayToType(Wanted::Kind wanted, const Value& found) {
  const bool isScalar = found.type == Type::Number || found.type == Type::Angle;
  if (wanted == Wanted::Kind::Point && found.isVector())
    return "add it to a point, as in `a + (0, 1)`";
  if (wanted == Wanted::Kind::Point && found.type == Type::Shape)
    return "a zone is a list of corners or one shape; shapes are joined by `|`, as in "
           "`hull(a, b, c) | disc(c, 1)`";
  if (wanted == Wanted::Kind::Vector && found.isPoint())
    return "a vector is the difference of two points, as in `b - a`";
  if (wanted == Wanted::Kind::Angle && found.type == Type::Number)
    return "an angle has a unit, as in 60deg";
  if (wanted == Wanted::Kind::Condition && isScalar)
    return std::string("compare it with something, as in `... < ") +
           (found.type == Type::Angle ? "90deg`" : "1`");
  if (wanted == Wanted::Kind::Condition)
    return "conditions are comparisons, ccw(...), convex(...), inside(...)";
  if (wanted == Wanted::Kind::Number) return wayToNumber(found);
  if (wanted == Wanted::Kind::Shape)
    return "shapes are made by poly, hull, disc, left, sector and grow";
  return {};
}

}  // namespace af2::dsl
