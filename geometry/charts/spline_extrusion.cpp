#include "geometry/charts/spline_extrusion.h"

#include <algorithm>
#include <cmath>

namespace af2::geometry {

namespace {

constexpr double kSlack = 1e-6;  // of the extent of the poles, or of a weight

/// The poles of a spline as rows across one of its parameters.
class Rows {
 public:
  Rows(const SplineDefinition& definition, bool alongU)
      : definition_(definition), alongU_(alongU) {}

  std::size_t count() const { return (alongU_ ? definition_.v : definition_.u).poleCount(); }
  std::size_t length() const { return (alongU_ ? definition_.u : definition_.v).poleCount(); }
  const Point3& pole(std::size_t row, std::size_t i) const {
    return definition_.poles[index(row, i)];
  }
  double weight(std::size_t row, std::size_t i) const {
    return definition_.weights.empty() ? 1 : definition_.weights[index(row, i)];
  }

 private:
  std::size_t index(std::size_t row, std::size_t i) const {
    return alongU_ ? i * definition_.v.poleCount() + row : row * definition_.v.poleCount() + i;
  }
  const SplineDefinition& definition_;
  bool alongU_;
};

double extentOf(const std::vector<Point3>& poles) {
  double extent = 0;
  for (const Point3& pole : poles) extent = std::max(extent, distance(pole, poles.front()));
  return extent;
}

/// All rows are the same straight line, moved, with weights in the same proportions.
std::optional<Point3> directionOf(const Rows& rows, double slack) {
  const Point3 whole = rows.pole(0, rows.length() - 1) - rows.pole(0, 0);
  if (!(length(whole) > slack)) return std::nullopt;
  const Point3 direction = unit(whole);
  for (std::size_t row = 0; row < rows.count(); ++row)
    for (std::size_t i = 0; i < rows.length(); ++i) {
      const double along = dot(rows.pole(0, i) - rows.pole(0, 0), direction);
      const Point3 moved = rows.pole(row, 0) + along * direction;
      const double weight = rows.weight(row, 0) * rows.weight(0, i) / rows.weight(0, 0);
      if (!(distance(rows.pole(row, i), moved) <= slack) ||
          !(std::abs(rows.weight(row, i) - weight) <= kSlack * weight))
        return std::nullopt;
    }
  return direction;
}

}  // namespace

std::optional<Extrusion> extrusionOf(const SplineDefinition& definition) {
  const double slack = kSlack * extentOf(definition.poles);
  for (const bool alongU : {false, true})
    if (const auto direction = directionOf(Rows(definition, alongU), slack))
      return Extrusion{*direction, alongU};
  return std::nullopt;
}

}  // namespace af2::geometry
