// Charts of the plane z = 0 that show some places only, or find some only on the surface.
#pragma once

#include <functional>
#include <memory>

#include "tests/support/flat_surface.h"

namespace af2::testing {

/// What charts can do, as on a surface that bends sharply. Empty: everything.
struct ChartSkill {
  /// Whether the chart of a base edge shows a place.
  std::function<bool(Point3 from, Point3 to, Point2 inChart)> shows;
  /// Whether a point of the surface is found.
  std::function<bool(const Point3&)> finds;
};

class LimitedChart final : public AF2LocalTransform {
 public:
  LimitedChart(const ChartSkill& skill, const Point3& from, const Point3& to, double unit)
      : skill_(skill), from_(from), to_(to), chart_(flatChart(from, to, unit)) {}

  ChartPoint transformFromSurface(const SurfacePoint& p) const override {
    ChartPoint point = chart_.transformFromSurface(p);
    if (skill_.shows && !skill_.shows(from_, to_, point.position)) point.view = ChartView::Hidden;
    return point;
  }
  std::optional<SurfacePoint> transformToSurface(Point2 p) const override {
    std::optional<SurfacePoint> found = chart_.transformToSurface(p);
    if (found && skill_.finds && !skill_.finds(found->position)) return std::nullopt;
    return found;
  }

 private:
  const ChartSkill& skill_;
  Point3 from_, to_;
  PlaneChart chart_;
};

class LimitedMaker final : public AF2LocalTransformMaker {
 public:
  explicit LimitedMaker(ChartSkill skill) : skill_(std::move(skill)) {}
  std::unique_ptr<AF2LocalTransform> makeLocalTransform(const SurfacePoint& from,
                                                        const SurfacePoint& to,
                                                        double unit) const override {
    return std::make_unique<LimitedChart>(skill_, from.position, to.position, unit);
  }

 private:
  ChartSkill skill_;
};

}  // namespace af2::testing
