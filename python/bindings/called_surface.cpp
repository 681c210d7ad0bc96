#include "python/bindings/called_surface.h"

#include <af2/engine/error.h>
#include <af2/geometry/normal_line_chart.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "python/bindings/called_chart.h"

namespace af2::python {

using geometry::ChartKind;
using geometry::SurfaceFrame;

bool CalledSurface::has(ChartKind kind) const {
  if (kind == ChartKind::Auto || kind == ChartKind::MeanNormal) return true;
  if (chart_) return false;  // fronts run in the charts of the user alone
  return kind == ChartKind::NormalLines || kind == ChartKind::Affine ||
         kind == ChartKind::Parametric;
}

py::object CalledSurface::chart(const SurfacePoint& from, const SurfacePoint& to,
                                double length) const {
  const auto tupleOf = [](const SurfacePoint& p) {
    return py::make_tuple(py::make_tuple(p.position.x, p.position.y, p.position.z),
                          py::make_tuple(p.normal.x, p.normal.y, p.normal.z),
                          py::make_tuple(p.u, p.v));
  };
  return (*chart_)(tupleOf(from), tupleOf(to), length);
}

std::vector<Point3> CalledSurface::asked(const py::object& function,
                                         const std::vector<Point2>& parameters,
                                         const char* name) const {
  std::vector<Point3> points;
  call_->back([&] {
    py::array_t<double> uv(
        std::vector<py::ssize_t>{static_cast<py::ssize_t>(parameters.size()), 2});
    std::copy(parameters.begin(), parameters.end(), reinterpret_cast<Point2*>(uv.mutable_data()));
    const py::object result = function(uv);
    try {
      points = points3(result, name);
      if (points.size() != parameters.size())
        throw InputError(std::string(name) + "(uv) returned " + std::to_string(points.size()) +
                         " rows for " + std::to_string(parameters.size()) + " parameters");
    } catch (const InputError& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
      throw py::error_already_set();
    }
  });
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::isfinite(points[i].x + points[i].y + points[i].z))
      throw GeometryError(std::string(name) + " has no finite value at (" +
                          std::to_string(parameters[i].x) + ", " + std::to_string(parameters[i].y) +
                          ")");
  return points;
}

/// Central differences; at the ends of the ranges one-sided.
SurfaceFrame CalledSurface::frameAt(double u, double v) const {
  constexpr double kStep = 1e-5;  // of the range: the errors of rounding and of curvature balance
  const double du = kStep * u_.width(), dv = kStep * v_.width();
  const double u0 = u_.clamped(u - du), u1 = u_.clamped(u + du);
  const double v0 = v_.clamped(v - dv), v1 = v_.clamped(v + dv);
  const auto p = positions({{u, v}, {u0, v}, {u1, v}, {u, v0}, {u, v1}});
  const double across = std::max(u1 - u0, du), along = std::max(v1 - v0, dv);
  return {p[0], (1 / across) * (p[2] - p[1]), (1 / along) * (p[4] - p[3])};
}

SurfacePoint CalledSurface::pointAt(double u, double v) const {
  if (normal_) {
    const Point3 normal = asked(*normal_, {{u, v}}, "normal").front();
    return {positions({{u, v}}).front(), unit(normal), u, v};
  }
  const SurfaceFrame frame = frameAt(u, v);
  return {frame.position, unit(cross(frame.du, frame.dv)), u, v};
}

void CalledSurface::takeSide() {
  if (!normal_) return;
  const double u = u_.low + 0.5 * u_.width(), v = v_.low + 0.5 * v_.width();
  const SurfaceFrame frame = frameAt(u, v);
  isFlipped_ = dot(cross(frame.du, frame.dv), pointAt(u, v).normal) < 0;
}

void CalledSurface::takeSeeds() {
  constexpr int kSeeds = 33;
  for (int i = 0; i < kSeeds; ++i)
    for (int j = 0; j < kSeeds; ++j)
      seedParameters_.push_back(
          {u_.low + i * u_.width() / (kSeeds - 1), v_.low + j * v_.width() / (kSeeds - 1)});
  seeds_ = positions(seedParameters_);
}

/// Gauss-Newton from the nearest seed.
SurfacePoint CalledSurface::nearest(const Point3& position) const {
  constexpr int kSteps = 12;
  const auto seed =
      std::ranges::min_element(seeds_, {}, [&](const Point3& p) { return distance(p, position); });
  Point2 at = seedParameters_[static_cast<std::size_t>(seed - seeds_.begin())];
  for (int step = 0; step < kSteps; ++step) {
    const SurfaceFrame frame = frameAt(at.x, at.y);
    const Point3 d = position - frame.position;
    const double uu = dot(frame.du, frame.du), vv = dot(frame.dv, frame.dv),
                 uv = dot(frame.du, frame.dv), det = uu * vv - uv * uv;
    if (!(det > 0)) break;
    const double ru = dot(d, frame.du), rv = dot(d, frame.dv);
    const Point2 next{u_.clamped(at.x + (ru * vv - rv * uv) / det),
                      v_.clamped(at.y + (rv * uu - ru * uv) / det)};
    const double moved =
        std::abs(next.x - at.x) / u_.width() + std::abs(next.y - at.y) / v_.width();
    at = next;
    if (moved < 1e-13) break;
  }
  return pointAt(at.x, at.y);
}

/// Newton's method in the plane of the chart.
std::optional<SurfacePoint> CalledSurface::hit(const geometry::SurfaceLine& line) const {
  constexpr int kSteps = 20;
  double u = 0.5 * (line.from.u + line.to.u), v = 0.5 * (line.from.v + line.to.v);
  for (int step = 0; step < kSteps; ++step) {
    const SurfaceFrame frame = frameAt(u, v);
    const Point3 d = line.start - frame.position;
    const double x = dot(d, line.xAxis), y = dot(d, line.yAxis);
    if (std::hypot(x, y) < 1e-12 * line.edgeLength) return pointAt(u, v);
    const Point2 du{dot(frame.du, line.xAxis), dot(frame.du, line.yAxis)};
    const Point2 dv{dot(frame.dv, line.xAxis), dot(frame.dv, line.yAxis)};
    const double det = cross(du, dv);
    if (det == 0 || !std::isfinite(det)) return std::nullopt;
    u = u_.clamped(u + cross({x, y}, dv) / det);
    v = v_.clamped(v + cross(du, {x, y}) / det);
  }
  const SurfacePoint point = pointAt(u, v);
  const Point3 d = line.start - point.position;
  const double miss = std::hypot(dot(d, line.xAxis), dot(d, line.yAxis));
  return miss < 1e-6 * line.edgeLength ? std::optional(point) : std::nullopt;
}

/// What charts keep of the surface.
struct HitSurface {
  const CalledSurface* surface;
  std::optional<SurfacePoint> hit(const geometry::SurfaceLine& line) const {
    return surface->hit(line);
  }
};

std::unique_ptr<AF2LocalTransformMaker> CalledSurface::makeCharts(ChartKind kind) const {
  if (chart_) return chartsOfPython(*this);
  switch (kind) {
    case ChartKind::Affine:
      return std::make_unique<geometry::MetricChartMaker>(*this, geometry::MetricOrder::First);
    case ChartKind::Parametric:
      return std::make_unique<geometry::MetricChartMaker>(*this, geometry::MetricOrder::Second);
    case ChartKind::NormalLines:
      return std::make_unique<geometry::NormalLineChartMaker<HitSurface>>(HitSurface{this});
    default:
      return std::make_unique<geometry::MeanNormalChartMaker<HitSurface>>(HitSurface{this});
  }
}

}  // namespace af2::python
