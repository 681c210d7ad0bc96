// A match of a rule's pattern with the front, as rules see it.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2 {

/// What a rule may query about the front around a match, in addition to the matched positions.
///
/// Vertices are identified by their index in the rule's pattern; lengths are in chart units, angles
/// in radians. The defaults describe a uniform size field and an otherwise empty front.
class AF2_EXPORT AF2Surroundings {
 public:
  virtual ~AF2Surroundings() = default;
  /// Wanted edge length at a point of the chart.
  virtual double size(Point2) const { return 1; }
  /// Free angle at a chain vertex, counter-clockwise from the next to the previous front vertex, in
  /// (0, 2 pi]; no value if the chain does not determine it.
  virtual std::optional<double> turn(int /*vertex*/) const { return std::nullopt; }
  /// Number of layers of elements between the vertex and the boundary.
  virtual int layer(int /*vertex*/) const { return 0; }
  virtual bool onBoundary(int /*vertex*/) const { return true; }
  /// Whether the vertex was given with the boundary, so that it never moves.
  virtual bool isFixed(int /*vertex*/) const { return true; }
  /// Wanted edge length at a vertex.
  virtual double sizeOf(int /*vertex*/) const { return 1; }
  /// The neighbours of a vertex along the front, in the chart; no value if they are not known.
  virtual std::optional<Point2> before(int /*vertex*/) const { return std::nullopt; }
  virtual std::optional<Point2> after(int /*vertex*/) const { return std::nullopt; }
  /// Number of elements that a vertex wants in its free angle: 1 more than the number of `bounds`
  /// that the angle reaches. The bounds are measured by `sweepOf`. Where the angle is not known,
  /// the front is taken to run straight.
  virtual int count(int vertex, const std::array<double, 3>& bounds) const;
  /// Number of elements at the vertex so far.
  virtual int valence(int /*vertex*/) const { return 0; }
  /// Number of edges in the front loop of the base edge.
  virtual int loopSize() const { return 0; }
  /// Distance from a point to the nearest front edge, the base included.
  virtual double distanceToFront(Point2) const { return 0; }
  /// Largest normal curvature times the wanted edge length.
  virtual double curvature(Point2) const { return 0; }
};

/// 1 more than the number of bounds that a sweep reaches.
inline int countOf(double sweep, const std::array<double, 3>& bounds) {
  int count = 1;
  for (const double bound : bounds) count += sweep >= bound;
  return count;
}

/// The matched vertices of one rule at one place of the front.
struct AF2Binding {
  /// Chart positions in pattern order; [0] is a = (0, 0), [1] is b = (|ab|, 0).
  std::span<const Point2> vertices;
  int level = 1;                                  ///< quality level of the base edge
  const AF2Surroundings* surroundings = nullptr;  ///< never null while the engine runs
};

/// A number that depends on a match: a condition (holds if nonzero) or a cost.
class AF2_EXPORT AF2BindingFunction {
 public:
  virtual ~AF2BindingFunction() = default;
  /// No value if the expression has none (division by zero, parallel lines).
  virtual std::optional<double> evaluate(const AF2Binding& binding) const = 0;
  /// A lower bound of the values at a quality level. The better it is, the more rules a step can
  /// leave out whose cost is too high in any case.
  virtual double leastAt(int /*level*/) const { return -std::numeric_limits<double>::infinity(); }
};

}  // namespace af2
