// A surface whose points, normals and charts are calls of Python.
#pragma once

#include <af2/geometry/charted_surface.h>
#include <af2/geometry/mean_normal_chart.h>
#include <af2/geometry/metric_chart.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "python/bindings/run.h"

namespace af2::python {

struct Range {
  double low = 0, high = 1;
  double width() const { return high - low; }
  double clamped(double value) const { return std::clamp(value, low, high); }
};

/// The functions of the user, and the ranges of the parameters.
struct GivenSurface {
  py::object evaluate;
  py::object normal;  ///< None: du x dv
  py::object chart;   ///< None: the charts of AF2
  Range u, v;
};

/// A surface for one run. Every answer is a call of Python, so it is slow, and threads wait for
/// each other.
class CalledSurface final : public geometry::ChartedSurface, public geometry::ParametricSurface {
 public:
  CalledSurface(const GivenSurface& given, std::shared_ptr<Call> call)
      : evaluate_(shared(given.evaluate)),
        normal_(given.normal.is_none() ? nullptr : shared(given.normal)),
        chart_(given.chart.is_none() ? nullptr : shared(given.chart)),
        u_(given.u),
        v_(given.v),
        call_(std::move(call)) {
    takeSide();
    takeSeeds();
  }

  bool isPlane() const override { return false; }
  bool has(geometry::ChartKind kind) const override;
  std::unique_ptr<AF2LocalTransformMaker> makeCharts(geometry::ChartKind kind) const override;
  const ParametricSurface* inParameters() const override { return this; }

  SurfacePoint at(double u, double v) const override { return pointAt(u, v); }
  bool has(double u, double v) const override {
    constexpr double kSlack = 1e-6;  // of the range
    return std::abs(u - u_.clamped(u)) <= kSlack * u_.width() &&
           std::abs(v - v_.clamped(v)) <= kSlack * v_.width();
  }
  bool isFlipped() const override { return isFlipped_; }
  geometry::SurfaceFrame frameAt(double u, double v) const override;
  SurfacePoint pointAt(double u, double v) const override;

  std::vector<Point3> positions(const std::vector<Point2>& parameters) const {
    return asked(*evaluate_, parameters, "evaluate");
  }
  /// Where the line meets the surface near the base edge.
  std::optional<SurfacePoint> hit(const geometry::SurfaceLine& line) const;
  SurfacePoint nearest(const Point3& position) const;

  /// Calls Python for the chart of the user.
  const std::shared_ptr<Call>& call() const { return call_; }
  py::object chart(const SurfacePoint& from, const SurfacePoint& to, double length) const;

 private:
  std::vector<Point3> asked(const py::object& function, const std::vector<Point2>& parameters,
                            const char* name) const;
  void takeSide();
  void takeSeeds();

  std::shared_ptr<py::object> evaluate_, normal_, chart_;  // the last two may be null
  Range u_, v_;
  std::shared_ptr<Call> call_;
  bool isFlipped_ = false;
  std::vector<Point2> seedParameters_;
  std::vector<Point3> seeds_;
};

}  // namespace af2::python
