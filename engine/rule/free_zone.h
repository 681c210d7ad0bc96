// The free zone of a rule: the region around a match that must be empty.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/export.h"
#include "engine/rule/binding.h"
#include "engine/rule/point_transform.h"
#include "engine/rule/refusal.h"

namespace af2 {

struct Box2 {
  Point2 low, high;
  bool contains(const Box2& other) const {
    return low.x <= other.low.x && low.y <= other.low.y && high.x >= other.high.x &&
           high.y >= other.high.y;
  }
};

/// Whether a point on the boundary of a zone counts as being in it.
enum class ZoneBoundary { Counts, Ignored };

/// A free zone at one match. Derive from this for a shape that the rule language cannot express.
///
/// The engine calls `contains(vertex, Counts)` and `meets(edge, Ignored)`: it tests vertices
/// against the closed zone and edges against its interior. It never asks about matched vertices and
/// edges.
class AF2_EXPORT AF2FreeZone {
 public:
  virtual ~AF2FreeZone() = default;
  /// A box that holds the whole zone; the engine never asks about anything outside it.
  virtual Box2 boundingBox() const = 0;
  virtual bool contains(Point2 point, ZoneBoundary boundary) const = 0;
  virtual bool meets(Point2 from, Point2 to, ZoneBoundary boundary) const = 0;
};

/// How a rule makes its free zone from a match. Source: [VanderZee16], free zone definitions.
class AF2_EXPORT AF2FreeZoneDef {
 public:
  struct Made {
    std::unique_ptr<const AF2FreeZone> zone;  ///< null: refused
    Refusal refusal = Refusal::None;          ///< NoValue, Shape or Convexity when null
  };

  virtual ~AF2FreeZoneDef() = default;
  virtual Made makeFreeZone(const AF2Binding& binding) const = 0;
  /// The vertices of the rule, matched and new ones, that are the corners of the zone at every
  /// match, if it is a polygon with straight sides; else none. Where this polygon is strictly
  /// convex, the engine tests it without making the zone.
  virtual std::span<const std::int8_t> cornerVertices() const { return {}; }
};

/// The convex polygon on plain arrays, used by both the open and the fast form of the zone.
namespace convex_polygon {

/// Largest depth, in chart units, to which a corner may lie inside the chord of its neighbours and
/// still count as straight. It allows for the rounding of corners that are collinear by
/// construction. For zones smaller than 1 it is relative to their extent.
inline constexpr double kStraightTolerance = 1e-9;

/// Removes, in place, corners that repeat their predecessor or lie a rounding error inside a chord.
/// Returns the number of corners left: 0 unless they run once, counter-clockwise, around a convex
/// region of positive area.
AF2_EXPORT int normalize(Point2* corners, int count, double straightTolerance = kStraightTolerance);

/// The following functions require normalized corners.
AF2_EXPORT bool contains(std::span<const Point2> corners, Point2 point, ZoneBoundary boundary);
AF2_EXPORT bool meets(std::span<const Point2> corners, Point2 from, Point2 to,
                      ZoneBoundary boundary);
/// The remaining test when no side of the polygon separates it from the segment, whose length is
/// not zero.
AF2_EXPORT bool meetsLine(std::span<const Point2> corners, Point2 from, Point2 to,
                          ZoneBoundary boundary);

}  // namespace convex_polygon

/// A convex polygon, corners counter-clockwise. Corners may coincide and may be straight.
class AF2_EXPORT ConvexPolygonZone final : public AF2FreeZone {
 public:
  /// Whether the corners run once around a convex region of positive area, counter-clockwise.
  static bool isConvex(std::span<const Point2> corners,
                       double straightTolerance = convex_polygon::kStraightTolerance);

  /// Throws InputError unless `isConvex(corners)`.
  explicit ConvexPolygonZone(std::vector<Point2> corners);

  Box2 boundingBox() const override;
  bool contains(Point2 point, ZoneBoundary boundary) const override;
  bool meets(Point2 from, Point2 to, ZoneBoundary boundary) const override;
  std::span<const Point2> corners() const { return corners_; }

 private:
  std::vector<Point2> corners_;  // normalized
};

/// The usual definition: a convex polygon whose corners move from preferred to limiting positions
/// as the quality level rises: corner = t * preferred + (1 - t) * limiting with t = fade[level].
class AF2_EXPORT ConvexPolygonZoneDef final : public AF2FreeZoneDef {
 public:
  struct Corner {
    std::shared_ptr<const AF2PointTransform> preferred;
    std::shared_ptr<const AF2PointTransform> limiting =
        nullptr;  ///< null: the preferred one at every level
  };

  /// fade  weight of the preferred corner by level; [0] is level 1; the last one applies to all
  ///       higher levels. Throws InputError with fewer than three corners or an empty fade.
  ConvexPolygonZoneDef(std::vector<Corner> corners, std::vector<double> fade);

  Made makeFreeZone(const AF2Binding& binding) const override;
  /// The corners at a match, in the order in which they were given, convex or not; no value if one
  /// of them has none.
  std::optional<std::vector<Point2>> cornersAt(const AF2Binding& binding) const;

  std::span<const Corner> corners() const { return corners_; }
  double fade(int level) const;

 private:
  std::vector<Corner> corners_;
  std::vector<double> fade_;
};

}  // namespace af2
