#include "python/bindings/called_chart.h"

#include <cmath>
#include <string>

namespace af2::python {
namespace {

py::array_t<double> rowOf(std::initializer_list<double> values) {
  py::array_t<double> row(std::vector<py::ssize_t>{1, static_cast<py::ssize_t>(values.size())});
  std::copy(values.begin(), values.end(), row.mutable_data());
  return row;
}

/// One row of two numbers, which a function of the chart returned. As errors of Python.
Point2 placeFrom(const py::object& result, const char* function) {
  try {
    const std::vector<Point2> places = points2(result, function);
    if (places.size() == 1) return places.front();
  } catch (const std::exception&) {
  }
  PyErr_SetString(PyExc_ValueError, (std::string(function) + " must return an array of the shape " +
                                     "(n, 2), one row for each point")
                                        .c_str());
  throw py::error_already_set();
}

class CalledChart final : public AF2LocalTransform {
 public:
  CalledChart(const CalledSurface& surface, const SurfacePoint& from, const SurfacePoint& to,
              double length)
      : surface_(surface) {
    surface.call()->back([&] { chart_ = shared(surface.chart(from, to, length)); });
    requireBase(from, to);
  }

  ChartPoint transformFromSurface(const SurfacePoint& point) const override {
    Point2 place;
    surface_.call()->back([&] { place = placeOf(point); });
    return {place, ChartView::Legal};
  }

  std::optional<SurfacePoint> transformToSurface(Point2 place) const override {
    Point2 uv;
    surface_.call()->back([&] {
      uv = placeFrom(chart_->attr("to_surface")(rowOf({place.x, place.y})), "to_surface");
    });
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y) || !surface_.has(uv.x, uv.y))
      return std::nullopt;
    return surface_.pointAt(uv.x, uv.y);
  }

 private:
  Point2 placeOf(const SurfacePoint& p) const {
    return placeFrom(
        chart_->attr("to_chart")(rowOf({p.position.x, p.position.y, p.position.z}),
                                 rowOf({p.normal.x, p.normal.y, p.normal.z}), rowOf({p.u, p.v})),
        "to_chart");
  }

  /// The base edge is where the engine expects it.
  void requireBase(const SurfacePoint& from, const SurfacePoint& to) const {
    constexpr double kNear = 1e-6;
    surface_.call()->back([&] {
      const Point2 start = placeOf(from), end = placeOf(to);
      if (length(start) < kNear && std::abs(end.y) < kNear && end.x > 0) return;
      PyErr_SetString(PyExc_ValueError,
                      "to_chart must map the start of the base edge to (0, 0) and its end to "
                      "(x, 0) with x > 0");
      throw py::error_already_set();
    });
  }

  const CalledSurface& surface_;
  std::shared_ptr<py::object> chart_;
};

class CalledChartMaker final : public AF2LocalTransformMaker {
 public:
  explicit CalledChartMaker(const CalledSurface& surface) : surface_(surface) {}

  std::unique_ptr<AF2LocalTransform> makeLocalTransform(const SurfacePoint& from,
                                                        const SurfacePoint& to,
                                                        double edgeLength) const override {
    return std::make_unique<CalledChart>(surface_, from, to, edgeLength);
  }

 private:
  const CalledSurface& surface_;
};

}  // namespace

std::unique_ptr<AF2LocalTransformMaker> chartsOfPython(const CalledSurface& surface) {
  return std::make_unique<CalledChartMaker>(surface);
}

}  // namespace af2::python
