#include "python/bindings/common.h"

#include <af2/engine/error.h>

#include <string>

namespace af2::python {
namespace {

std::string shapeOf(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  return text + (array.ndim() == 1 ? ",)" : ")");
}

PointArray checkedArray(const py::handle& object, const char* argument, int least, int most) {
  PointArray array;
  try {
    array = PointArray::ensure(object);
  } catch (const py::error_already_set&) {
    array = {};
  }
  if (!array) {
    PyErr_Clear();
    throw InputError(std::string(argument) + ": this is no array of numbers");
  }
  if (array.size() == 0 && array.ndim() <= 2) return PointArray(std::vector<py::ssize_t>{0, most});
  if (array.ndim() != 2 || array.shape(1) < least || array.shape(1) > most) {
    const std::string columns = least == most
                                    ? std::to_string(most)
                                    : std::to_string(least) + " or " + std::to_string(most);
    throw InputError(std::string(argument) + ": the shape must be (n, " + columns + "), not " +
                     shapeOf(array));
  }
  return array;
}

}  // namespace

py::array arrayOf(const std::vector<Point3>& points) {
  static_assert(sizeof(Point3) == 3 * sizeof(double));
  py::array_t<double> array(std::vector<py::ssize_t>{static_cast<py::ssize_t>(points.size()), 3});
  std::copy(points.begin(), points.end(), reinterpret_cast<Point3*>(array.mutable_data()));
  return array;
}

std::vector<Point3> points3(const py::handle& object, const char* argument) {
  const PointArray array = checkedArray(object, argument, 2, 3);
  const auto rows = array.unchecked<2>();
  std::vector<Point3> points(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    points[static_cast<std::size_t>(i)] = {rows(i, 0), rows(i, 1),
                                           rows.shape(1) == 3 ? rows(i, 2) : 0};
  return points;
}

std::vector<Point2> points2(const py::handle& object, const char* argument) {
  const PointArray array = checkedArray(object, argument, 2, 2);
  const auto rows = array.unchecked<2>();
  std::vector<Point2> points(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    points[static_cast<std::size_t>(i)] = {rows(i, 0), rows(i, 1)};
  return points;
}

}  // namespace af2::python
