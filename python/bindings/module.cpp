// The extension module af2._af2, on which the package af2 stands.
#include <af2/engine/error.h>

#include "python/bindings/common.h"
#include "python/bindings/trace.h"

PYBIND11_MODULE(_af2, module) {
  namespace python = af2::python;
  namespace py = pybind11;
  module.attr("version") = AF2_VERSION;
  py::register_exception<af2::InputError>(module, "InputError", PyExc_ValueError);
  py::register_exception<af2::GeometryError>(module, "GeometryError", PyExc_RuntimeError);
  py::register_exception<af2::InternalError>(module, "InternalError", PyExc_RuntimeError);
  python::bindReports(module);
  python::bindTrace(module);
  python::bindModels(module);
  python::bindRules(module);
  python::bindMesh(module);
  python::bindMeshParts(module);
}
