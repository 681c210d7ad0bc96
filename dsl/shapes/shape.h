// Zones of any shape: the evaluated forms of `poly`, `disc`, `hull`, `|`, `=>` and the others.
//
// Use: build a Shape from evaluated points and numbers, `fade` it if there is a limiting shape, and
// pass it to `makeZone`. `fadeMismatch` and `isBounded` detect errors of the text: different
// constructors on the two sides of `=>`, and an unbounded zone.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/point.h"
#include "engine/rule/free_zone.h"

namespace af2::dsl {

enum class ShapeKind {
  Convex,  ///< a corner list, as `zone` takes it: convex or refused
  Poly,
  Disc,
  Left,
  Sector,
  Hull,
  Grow,
  Union,
  Intersection,
  Difference,
  User  ///< a registered shape
};

/// The name of a constructor as rule files write it: "disc", "|"; "corner list" for Convex.
const char* toString(ShapeKind kind);

/// One step of a `poly` path, from the end of the previous step (for the first step: of the last
/// one).
struct PathStep {
  Point2 to;
  std::optional<Point2> via;  ///< if set, the step is the circular arc through this point
};

/// A closed set of the chart: a tree of constructors with evaluated numbers.
///
/// Sets are regular: they do not contain parts without area, such as a common edge of two parts
/// that only touch, or the slit between two subtracted parts. A part may have no area, for example
/// after it has faded to nothing; it then contains no point, but can still be grown. Nothing is
/// checked here; see makeZone.
class Shape {
 public:
  /// Corners counter-clockwise.
  static Shape convex(std::vector<Point2> corners);
  /// A simple closed path, counter-clockwise. Steps of zero length are skipped; an arc whose `via`
  /// is on the chord is straight.
  static Shape poly(std::vector<PathStep> path);
  static Shape disc(Point2 centre, double radius);
  /// The half plane to the left of the line through `point` along `direction`.
  static Shape left(Point2 point, Point2 direction);
  /// The part of a disc counter-clockwise from the angle `from` to the angle `to`, in radians from
  /// the x axis. Equal angles give the empty set; a full turn or more gives the disc.
  static Shape sector(Point2 centre, double radius, double from, double to);
  /// The convex hull of any number of points; one or two points are useful with `grow`.
  static Shape hull(std::vector<Point2> points);
  /// All points at a distance of at most `distance` (>= 0) from `shape`.
  static Shape grow(Shape shape, double distance);
  /// A registered shape. If there is no zone, the match is refused for this reason.
  static Shape user(std::shared_ptr<const AF2FreeZone> zone, Refusal refusal);
  friend Shape operator|(Shape first, Shape second);
  friend Shape operator&(Shape first, Shape second);
  friend Shape operator-(Shape first, Shape second);

  ShapeKind kind() const { return kind_; }
  /// Corners, path (for each step its `via`, if any, then its end), centre, or point and direction.
  const std::vector<Point2>& points() const { return points_; }
  /// Radius; radius, from, to; distance.
  const std::vector<double>& numbers() const { return numbers_; }
  /// Poly: for each step whether it is an arc.
  const std::vector<bool>& arcs() const { return arcs_; }
  const std::vector<Shape>& parts() const { return parts_; }
  /// The zone of a registered shape; null if it is refused.
  const std::shared_ptr<const AF2FreeZone>& zone() const { return zone_; }
  Refusal refusal() const { return refusal_; }
  bool operator==(const Shape&) const = default;

 private:
  friend std::optional<Shape> fade(const Shape& preferred, const Shape& limiting, double t);
  Shape(ShapeKind kind, std::vector<Point2> points, std::vector<double> numbers,
        std::vector<Shape> parts = {});

  ShapeKind kind_;
  std::vector<Point2> points_;
  std::vector<double> numbers_;
  std::vector<bool> arcs_;
  std::vector<Shape> parts_;
  std::shared_ptr<const AF2FreeZone> zone_;
  Refusal refusal_ = Refusal::None;
};

/// `preferred => limiting`: t * preferred + (1 - t) * limiting, number by number; nothing if the
/// two shapes have different constructors.
std::optional<Shape> fade(const Shape& preferred, const Shape& limiting, double t);

/// Why two shapes cannot fade into each other ("a disc cannot fade into a hull"); nothing if they
/// can. The answer depends only on constructors and counts, so the reference match is sufficient.
std::optional<std::string> fadeMismatch(const Shape& preferred, const Shape& limiting);

/// Whether the shape is bounded; true for shapes that makeZone refuses for another reason. Exact.
/// Only half planes are unbounded.
bool isBounded(const Shape& shape);

/// A zone, or the reason why there is none at this match.
struct MadeZone {
  std::unique_ptr<const AF2FreeZone> zone;  ///< null: refused
  Refusal refusal = Refusal::None;          ///< NoValue, Shape or Convexity when null
  const char* reason = "";  ///< a phrase that names the fault: "the path crosses itself"
};

/// The free zone of a shape.
///
/// Every answer of the zone is exact for the given numbers: it distinguishes a point or an edge
/// that touches the boundary from one that enters by the last bit. An edge along an inner seam of a
/// union meets the zone; an edge that touches the zone from outside does not. A zone with
/// registered shapes among its parts is as exact as these shapes, see shapes/mixed_zone.h. Two
/// kinds of sets are rounded before use: flanks of a sector at angles that are not multiples of 90
/// degrees, and the result of `grow` for half planes, arcs, `&` and `-`.
///
/// Refused: numbers that are not finite or beyond 1e75, a `left` without direction (NoValue);
/// corners that are not convex (Convexity); a negative radius or distance, a path that crosses or
/// touches itself, runs clockwise or has no area, an unbounded zone (Shape).
MadeZone makeZone(const Shape& shape);

/// Whether the closed shape contains a point. The shape may be unbounded or empty. Nothing if
/// makeZone refuses it for another reason.
std::optional<bool> holds(const Shape& shape, Point2 point);

/// The boundary for drawing: closed loops with the shape on their left, arcs sampled so that no
/// chord is farther than `sag` from its arc. Empty if makeZone refuses the shape.
std::vector<std::vector<Point2>> outline(const Shape& shape, double sag = 1e-3);

/// The same for any zone. The boundary of a registered zone, whose form is unknown, is traced in
/// steps of a hundredth of its box.
std::vector<std::vector<Point2>> outline(const AF2FreeZone& zone, double sag = 1e-3);

}  // namespace af2::dsl
