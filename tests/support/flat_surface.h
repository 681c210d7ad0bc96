// The plane z = 0 as a surface, and regions on it, for tests of the engine without any geometry
// room.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "engine/base/error.h"
#include "engine/mesh/front_input.h"
#include "engine/run/region_split.h"
#include "engine/surface/plane_chart.h"

namespace af2::testing {

using FlatMaker = PlaneChartMaker;

inline PlaneChart flatChart(const Point3& from, const Point3& to, double unit) {
  constexpr Point3 kUp{0, 0, 1};
  return PlaneChart({from, kUp}, {to, kUp}, kUp, unit);
}

/// The same chart without its fast form.
class SlowFlatChart final : public AF2LocalTransform {
 public:
  SlowFlatChart(const SurfacePoint& from, const SurfacePoint& to, double unit)
      : chart_(from, to, {0, 0, 1}, unit) {}
  ChartPoint transformFromSurface(const SurfacePoint& p) const override {
    return chart_.transformFromSurface(p);
  }
  std::optional<SurfacePoint> transformToSurface(Point2 p) const override {
    return chart_.transformToSurface(p);
  }

 private:
  PlaneChart chart_;
};

class SlowFlatMaker final : public AF2LocalTransformMaker {
 public:
  std::unique_ptr<AF2LocalTransform> makeLocalTransform(const SurfacePoint& from,
                                                        const SurfacePoint& to,
                                                        double unit) const override {
    return std::make_unique<SlowFlatChart>(from, to, unit);
  }
};

class FlatPoints final : public SurfaceEvaluator {
 public:
  SurfacePoint at(double u, double v) const override { return {{u, v, 0}, {0, 0, 1}, u, v}; }
};

inline BoundaryCorner flatCorner(std::size_t id, Point2 p) {
  return {VertexId(id), {{p.x, p.y, 0}, {0, 0, 1}, p.x, p.y}};
}

/// Adds a closed polygon, its vertices numbered on.
inline void addLoop(FrontInput& input, const std::vector<Point2>& polygon) {
  std::vector<BoundaryCorner> loop;
  for (Point2 p : polygon) loop.push_back(flatCorner(input.vertexCount++, p));
  input.loops.push_back(std::move(loop));
}

/// Each side of a closed polygon divided into equal parts of about `size`.
inline std::vector<Point2> divided(const std::vector<Point2>& corners, double size) {
  std::vector<Point2> result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2 p = corners[i], q = corners[(i + 1) % corners.size()];
    const int n = std::max(1, static_cast<int>(std::lround(distance(p, q) / size)));
    for (int k = 0; k < n; ++k) result.push_back(p + (static_cast<double>(k) / n) * (q - p));
  }
  return result;
}

inline std::vector<Point2> circle(Point2 center, double radius, int n, bool clockwise = false) {
  std::vector<Point2> result;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * M_PI * i / n * (clockwise ? -1 : 1);
    result.push_back(center + radius * Point2{std::cos(t), std::sin(t)});
  }
  return result;
}

inline FrontInput square(double size) {
  FrontInput input;
  addLoop(input, divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, size));
  return input;
}

inline FrontInput discWithHole(double size) {
  FrontInput input;
  const auto parts = [&](double r) { return static_cast<int>(std::lround(2 * M_PI * r / size)); };
  addLoop(input, circle({0, 0}, .5, parts(.5)));
  addLoop(input, circle({0, 0}, .17, parts(.17), true));
  return input;
}

}  // namespace af2::testing
