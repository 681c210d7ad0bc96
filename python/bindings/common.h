// What all files of the Python module share: pybind11, and arrays that own nothing.
#pragma once

#include <af2/engine/point.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstdint>
#include <vector>

namespace af2::python {

namespace py = pybind11;

/// Points in C++ order, converted from anything that NumPy takes.
using PointArray = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A read-only array over data of `owner`, which it keeps alive.
template <class T>
py::array viewOf(const py::handle& owner, const T* data, std::vector<py::ssize_t> shape,
                 std::vector<py::ssize_t> strides) {
  py::array array(py::dtype::of<T>(), std::move(shape), std::move(strides), data, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// The same over one member of each element of a list of structures.
template <class T, class Item>
py::array memberView(const py::handle& owner, const std::vector<Item>& items, const T Item::*member,
                     py::ssize_t columns = 1) {
  const T* data = items.empty() ? nullptr : &(items.front().*member);
  const auto count = static_cast<py::ssize_t>(items.size());
  const auto stride = static_cast<py::ssize_t>(sizeof(Item));
  if (columns == 1) return viewOf(owner, data, {count}, {stride});
  return viewOf(owner, data, {count, columns}, {stride, static_cast<py::ssize_t>(sizeof(T))});
}

/// An array of the rows of `values`, with a copy of them. For results that nothing else owns.
template <class T>
py::array arrayOf(const std::vector<T>& values) {
  return py::array_t<T>(static_cast<py::ssize_t>(values.size()), values.data());
}
py::array arrayOf(const std::vector<Point3>& points);

/// Throws InputError, naming the argument, unless the array has two dimensions and so many columns.
/// Two columns where three are wanted stand for z = 0.
std::vector<Point3> points3(const py::handle& array, const char* argument);
std::vector<Point2> points2(const py::handle& array, const char* argument);

void bindModels(py::module_& module);
void bindRules(py::module_& module);
void bindMesh(py::module_& module);
void bindReports(py::module_& module);
void bindMeshParts(py::module_& module);

}  // namespace af2::python
