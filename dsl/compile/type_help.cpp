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

std::string wayToType(std::string_view wanted, const Value& found) {
  const auto wants = [&](std::string_view type) { return wanted.starts_with(type); };
  const bool isScalar = found.type == Type::Number || found.type == Type::Angle;
  if (wants("a point") && found.isVector()) return "add it to a point, as in `a + (0, 1)`";
  if (wants("a point") && found.type == Type::Shape)
    return "a zone is a list of corners or one shape; shapes are joined by `|`, as in "
           "`hull(a, b, c) | disc(c, 1)`";
  if (wants("a vector") && found.isPoint())
    return "a vector is the difference of two points, as in `b - a`";
  if (wants("an angle") && found.type == Type::Number) return "an angle has a unit, as in 60deg";
  if (wants("a condition") && isScalar)
    return std::string("compare it with something, as in `... < ") +
           (found.type == Type::Angle ? "90deg`" : "1`");
  if (wants("a condition")) return "conditions are comparisons, ccw(...), convex(...), inside(...)";
  if (wants("a number")) return wayToNumber(found);
  if (wants("a shape")) return "shapes are made by poly, hull, disc, left, sector and grow";
  return {};
}

}  // namespace af2::dsl
