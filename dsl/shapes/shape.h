// Zones of any shape: the values that `poly`, `disc`, `left`, `sector`, `hull`, `grow`, `|`, `&`,
// `-` and `=>` build once the expressions inside them are numbers.
//
// Use: build a Shape from evaluated points and numbers, `fade` it if there is a limiting one, and
// hand it to `makeZone`. What the language calls an error of the text (different constructors on
// the two sides of `=>`, an unbounded zone) is asked for with `fadeMismatch` and `isBounded`.
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

/// One step of a `poly` path, from where the step before it ended (for the first one: the last).
struct PathStep {
  Point2 to;
  std::optional<Point2> via;  ///< the step is the circular arc through this point; else straight
};

/// A closed set of the chart, as written: a tree of constructors with evaluated numbers.
///
/// Sets are regular: what has no area (a common edge of two parts that only touch, the slit between
/// two parts taken away) is not in them. A part may have no area at all, as when it fades to
/// nothing; it then holds nothing, but can still be grown. Nothing is checked here; see makeZone.
class Shape {
 public:
  /// Corners counter-clockwise.
  static Shape convex(std::vector<Point2> corners);
  /// A simple closed path, counter-clockwise. Steps of no length are passed over; an arc whose
  /// `via` lies on the chord is straight.
  static Shape poly(std::vector<PathStep> path);
  static Shape disc(Point2 centre, double radius);
  /// The half plane to the left of the line through `point` along `direction`.
  static Shape left(Point2 point, Point2 direction);
  /// The part of a disc counter-clockwise from the angle `from` to the angle `to`, in radians from
  /// the x axis. Equal angles: nothing; a full turn or more: the disc.
  static Shape sector(Point2 centre, double radius, double from, double to);
  /// The convex hull of any number of points; one or two are good for `grow`.
  static Shape hull(std::vector<Point2> points);
  /// All points at a distance of at most `distance` (>= 0) from `shape`.
  static Shape grow(Shape shape, double distance);
  /// A registered shape; without a zone: refused for this reason.
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
  /// Of a registered shape; null: refused.
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
/// two are not built by the same constructors.
std::optional<Shape> fade(const Shape& preferred, const Shape& limiting, double t);

/// Why two shapes cannot fade into each other ("a disc cannot fade into a hull"); nothing if they
/// can. Depends on constructors and counts alone, so it may be asked at the reference match.
std::optional<std::string> fadeMismatch(const Shape& preferred, const Shape& limiting);

/// Whether the shape lies in some box; true of shapes that makeZone refuses for another reason.
/// Exact. Half planes are the only parts that lie in none.
bool isBounded(const Shape& shape);

/// A zone, or why there is none at this match.
struct MadeZone {
  std::unique_ptr<const AF2FreeZone> zone;  ///< null: refused
  Refusal refusal = Refusal::None;          ///< NoValue, Shape or Convexity when null
  const char* reason = "";                  ///< what is wrong, a phrase: "the path crosses itself"
};

/// The free zone of a shape.
///
/// Every answer of the zone is exact for the numbers as given: a point or an edge that touches the
/// boundary is told from one that enters by the last bit. An edge that runs along an inner seam of
/// a union meets the zone, one that touches it from outside does not. A zone with registered shapes
/// among its parts is as exact as these are, see shapes/mixed_zone.h. Two derived sets are rounded
/// before they are used: the flanks of a sector that are not multiples of 90 degrees, and what
/// `grow` makes of half planes, arcs, `&` and `-`.
///
/// Refused: numbers that are not finite or beyond 1e75, a `left` without direction (NoValue);
/// corners that are not convex (Convexity); a negative radius or distance, a path that crosses or
/// touches itself, runs clockwise or has no area, an unbounded zone (Shape).
MadeZone makeZone(const Shape& shape);

/// Whether a point lies in the closed shape, which may be unbounded or empty; nothing if makeZone
/// refuses it for another reason.
std::optional<bool> holds(const Shape& shape, Point2 point);

/// The boundary for drawing: closed loops with the shape on their left, arcs sampled so that no
/// chord is farther than `sag` from its arc. Empty if makeZone refuses the shape.
std::vector<std::vector<Point2>> outline(const Shape& shape, double sag = 1e-3);

/// The same for any zone. Of one whose form is not known, a user's own, the boundary is traced in
/// steps of a hundredth of its box.
std::vector<std::vector<Point2>> outline(const AF2FreeZone& zone, double sag = 1e-3);

}  // namespace af2::dsl
