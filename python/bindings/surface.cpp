// Surfaces that a Python class gives by evaluate(uv) and normal(uv).
#include <af2/engine/error.h>
#include <af2/geometry/mean_normal_chart.h>
#include <af2/geometry/metric_chart.h>
#include <af2/geometry/normal_line_chart.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "python/bindings/model.h"

namespace af2::python {
namespace {

using geometry::ChartKind;
using geometry::SurfaceFrame;

struct Range {
  double low = 0, high = 1;
  double width() const { return high - low; }
  double clamped(double value) const { return std::clamp(value, low, high); }
};

/// The class of the user, and the ranges of its parameters.
struct GivenSurface {
  py::object evaluate, normal;  ///< normal: may be None
  Range u, v;
};

/// A surface for one run. Every answer is a call of Python, so it is slow, and threads wait for
/// each other.
class CalledSurface final : public geometry::ChartedSurface, public geometry::ParametricSurface {
 public:
  CalledSurface(const GivenSurface& given, std::shared_ptr<Call> call)
      : evaluate_(shared(given.evaluate)),
        normal_(given.normal.is_none() ? nullptr : shared(given.normal)),
        u_(given.u),
        v_(given.v),
        call_(std::move(call)) {
    takeSide();
    takeSeeds();
  }

  bool isPlane() const override { return false; }
  bool has(ChartKind kind) const override {
    return kind == ChartKind::Auto || kind == ChartKind::MeanNormal ||
           kind == ChartKind::NormalLines || kind == ChartKind::Affine ||
           kind == ChartKind::Parametric;
  }
  std::unique_ptr<AF2LocalTransformMaker> makeCharts(ChartKind kind) const override;
  const ParametricSurface* inParameters() const override { return this; }

  SurfacePoint at(double u, double v) const override { return pointAt(u, v); }
  bool has(double u, double v) const override {
    constexpr double kSlack = 1e-6;  // of the range
    return std::abs(u - u_.clamped(u)) <= kSlack * u_.width() &&
           std::abs(v - v_.clamped(v)) <= kSlack * v_.width();
  }
  bool isFlipped() const override { return isFlipped_; }
  SurfaceFrame frameAt(double u, double v) const override;
  SurfacePoint pointAt(double u, double v) const override;

  std::vector<Point3> positions(const std::vector<Point2>& parameters) const {
    return asked(*evaluate_, parameters, "evaluate");
  }
  /// Where the line meets the surface near the base edge.
  std::optional<SurfacePoint> hit(const geometry::SurfaceLine& line) const;
  SurfacePoint nearest(const Point3& position) const;

 private:
  std::vector<Point3> asked(const py::object& function, const std::vector<Point2>& parameters,
                            const char* name) const;
  void takeSide();
  void takeSeeds();

  std::shared_ptr<py::object> evaluate_, normal_;
  Range u_, v_;
  std::shared_ptr<Call> call_;
  bool isFlipped_ = false;
  std::vector<Point2> seedParameters_;
  std::vector<Point3> seeds_;
};

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

using Loops = std::vector<std::vector<Point2>>;

/// The faces and curves of a run, from loops in the parameters.
class SurfaceDomain {
 public:
  SurfaceDomain(std::shared_ptr<const CalledSurface> surface, std::string name)
      : surface_(std::move(surface)) {
    model_.name = std::move(name);
  }

  std::shared_ptr<const geometry::DomainModel> make(const Loops& loops) {
    geometry::DomainFace face;
    face.surfaceType = "python";
    face.surface = surface_;
    face.nearest = [surface = surface_](const Point3& p) { return surface->nearest(p); };
    for (const std::vector<Point2>& loop : loops) addLoop(loop, face);
    face.area = areaOf(loops);
    measure();
    model_.faces.push_back(std::move(face));
    return std::make_shared<const geometry::DomainModel>(std::move(model_));
  }

 private:
  void addLoop(const std::vector<Point2>& loop, geometry::DomainFace& face) {
    const std::size_t first = model_.corners.size();
    for (const Point3& corner : surface_->positions(loop)) model_.corners.push_back(corner);
    std::vector<geometry::CurveUse>& uses = face.loops.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t next = (i + 1) % loop.size();
      uses.push_back({model_.curves.size(), false});
      addCurve(first + i, first + next, loop[i], loop[next]);
    }
  }

  /// Straight in the parameters.
  void addCurve(std::size_t first, std::size_t last, Point2 from, Point2 to) {
    constexpr int kKnots = 32;
    geometry::DomainCurve curve;
    curve.id = static_cast<int>(model_.curves.size()) + 1;
    curve.first = first;
    curve.last = last;
    for (int k = 0; k <= kKnots; ++k) curve.knots.push_back(k / double{kKnots});
    curve.pointAt = [surface = surface_, from, to](double t) {
      return surface->positions({from + t * (to - from)}).front();
    };
    model_.curves.push_back(std::move(curve));
  }

  /// By a grid over the loops, for the check of the mesh and the expected number of elements.
  double areaOf(const Loops& loops) const;

  void measure() {
    Point3 low = model_.corners.front(), high = low;
    for (const geometry::DomainCurve& curve : model_.curves)
      for (const double knot : curve.knots) {
        const Point3 p = curve.pointAt(knot);
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    model_.diagonal = distance(low, high);
  }

  std::shared_ptr<const CalledSurface> surface_;
  geometry::DomainModel model_;
};

bool isInside(const Loops& loops, Point2 p) {
  bool isIn = false;
  for (const std::vector<Point2>& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point2 a = loop[i], b = loop[(i + 1) % loop.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
        isIn = !isIn;
    }
  return isIn;
}

double SurfaceDomain::areaOf(const Loops& loops) const {
  constexpr int kCells = 200;  // each way; cells count if their middle is inside
  Point2 low = loops.front().front(), high = low;
  for (const auto& loop : loops)
    for (const Point2 p : loop) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  const Point2 cell = (1.0 / kCells) * (high - low);
  std::vector<Point2> nodes;
  for (int i = 0; i <= kCells; ++i)
    for (int j = 0; j <= kCells; ++j) nodes.push_back(low + Point2{i * cell.x, j * cell.y});
  const std::vector<Point3> at = surface_->positions(nodes);
  double area = 0;
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j) {
      if (!isInside(loops, low + Point2{(i + 0.5) * cell.x, (j + 0.5) * cell.y})) continue;
      const auto node = static_cast<std::size_t>(i * (kCells + 1) + j);
      area += 0.5 *
              length(cross(at[node + kCells + 2] - at[node], at[node + 1] - at[node + kCells + 1]));
    }
  return area;
}

class SurfaceModel final : public MeshableModel {
 public:
  SurfaceModel(GivenSurface given, Loops loops, std::string name)
      : given_(new GivenSurface(std::move(given)),
               [](GivenSurface* owned) {
                 const py::gil_scoped_acquire gil;
                 delete owned;
               }),
        loops_(std::move(loops)),
        name_(std::move(name)) {}

  const char* kind() const override { return "surface"; }

  Meshed mesh(const Request& request, const AF2Algorithm& algorithm) const override {
    return meshedDomain(domain(request.call), request, algorithm);
  }
  Parts parts(double, const std::shared_ptr<Call>& call) const override {
    return partsOf(*domain(call));
  }

 private:
  std::shared_ptr<const geometry::DomainModel> domain(const std::shared_ptr<Call>& call) const {
    std::shared_ptr<const CalledSurface> surface;
    {
      const py::gil_scoped_acquire gil;
      surface = std::make_shared<const CalledSurface>(*given_, call);
    }
    return SurfaceDomain(std::move(surface), name_).make(loops_);
  }

  std::shared_ptr<const GivenSurface> given_;
  Loops loops_;
  std::string name_;
};

}  // namespace

ModelPointer surfaceFrom(const py::dict& from) {
  const auto range = [&](const char* key) {
    const auto [low, high] = from[key].cast<std::pair<double, double>>();
    return Range{low, high};
  };
  Loops loops;
  for (const auto& loop : from["loops"].cast<py::list>()) loops.push_back(points2(loop, "loops"));
  return std::make_shared<const SurfaceModel>(
      GivenSurface{from["evaluate"], from["normal"], range("u"), range("v")}, std::move(loops),
      from["name"].cast<std::string>());
}

}  // namespace af2::python
