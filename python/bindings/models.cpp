// The classes of models in Python.
#include <af2/engine/error.h>
#include <af2/geometry/facets.h>
#include <af2/geometry/model.h>
#include <af2/geometry/planar_file.h>

#include "python/bindings/model.h"

namespace af2::python {
namespace {

/// The content or the extension tells what it is, as for `af2 mesh`.
ModelPointer read(const std::filesystem::path& path) {
  if (geometry::formatOf(geometry::planarFormats(), path)) return planarModelFrom(path);
  if (geometry::formatOf(geometry::facetFormats(), path)) return trianglesFrom(path);
  return cadModelFrom(path);
}

/// Reading cannot be stopped, but other threads of Python go on meanwhile.
ModelPointer readWithoutGil(const std::filesystem::path& path) {
  const py::gil_scoped_release noGil;
  return read(path);
}

void checkId(const char* argument, const char* kind, int id, int count) {
  if (id >= 1 && id <= count) return;
  throw InputError(std::string(argument) + ": there is no " + kind + " " + std::to_string(id) +
                   "; the model has " + kind + "s 1 to " + std::to_string(count));
}

void bindParts(py::module_& module) {
  py::class_<FaceEntry>(module, "FaceEntry")
      .def_readonly("id", &FaceEntry::id)
      .def_readonly("name", &FaceEntry::name)
      .def_readonly("surface", &FaceEntry::surface)
      .def_readonly("area", &FaceEntry::area)
      .def_readonly("edges", &FaceEntry::edges);
  py::class_<geometry::EdgeEntry>(module, "EdgeEntry")
      .def_readonly("id", &geometry::EdgeEntry::id)
      .def_readonly("curve", &geometry::EdgeEntry::curve)
      .def_readonly("length", &geometry::EdgeEntry::length)
      .def_property_readonly("start",
                             [](const geometry::EdgeEntry& edge) {
                               return py::make_tuple(edge.from.x, edge.from.y, edge.from.z);
                             })
      .def_property_readonly("end",
                             [](const geometry::EdgeEntry& edge) {
                               return py::make_tuple(edge.to.x, edge.to.y, edge.to.z);
                             })
      .def_readonly("faces", &geometry::EdgeEntry::faces);
  py::class_<Parts>(module, "Parts")
      .def_readonly("faces", &Parts::faces)
      .def_readonly("edges", &Parts::edges)
      .def_readonly("groups", &Parts::groups)
      .def_readonly("boundaries", &Parts::boundaries);
}

void bindFindings(py::module_& module) {
  using geometry::Defect, geometry::PartContact, geometry::PartContacts;
  const auto tupleOf = [](const Point3& p) { return py::make_tuple(p.x, p.y, p.z); };
  py::class_<Defect>(module, "Defect")
      .def_property_readonly("kind", [](const Defect& d) { return std::string(toString(d.kind)); })
      .def_readonly("face", &Defect::face)
      .def_readonly("edge", &Defect::edge)
      .def_readonly("vertex", &Defect::vertex)
      .def_readonly("extent", &Defect::extent)
      .def_property_readonly("place", [=](const Defect& d) { return tupleOf(d.place); })
      .def_readonly("detail", &Defect::detail);
  py::class_<PartContact>(module, "PartContact")
      .def_property_readonly("kind",
                             [](const PartContact& c) { return std::string(toString(c.kind)); })
      .def_property_readonly("parts",
                             [](const PartContact& c) { return py::make_tuple(c.one, c.other); })
      .def_readonly("area", &PartContact::area)
      .def_readonly("length", &PartContact::length)
      .def_readonly("volume", &PartContact::volume)
      .def_property_readonly("place", [=](const PartContact& c) { return tupleOf(c.place); })
      .def_readonly("equal_faces", &PartContact::twins);
  py::class_<PartContacts>(module, "PartContacts")
      .def_readonly("parts", &PartContacts::parts)
      .def_readonly("pairs", &PartContacts::pairs)
      .def_readonly("not_compared", &PartContacts::notCompared);
}

/// Asks a model, which may call Python.
template <class Answer>
auto askedOf(Answer answer) {
  return [answer](const MeshableModel& model, double size) {
    const auto call = std::make_shared<Call>();
    decltype(answer(model, size, call)) result;
    call->run([&] { result = answer(model, size, call); });
    return result;
  };
}

}  // namespace

std::shared_ptr<const MeshableModel> MeshableModel::named(
    const std::vector<std::pair<std::string, std::vector<int>>>&) const {
  throw InputError("names are for CAD models");
}

void checkIds(const Request& request, int faces, int edges) {
  const geometry::MeshingOptions& options = request.options;
  for (const int face : options.faces) checkId("faces", "face", face, faces);
  for (const auto& [face, size] : options.sizes.faceSizes)
    checkId("face_sizes", "face", face, faces);
  for (const auto& [face, bound] : options.sizes.chords.faces)
    checkId("face_chords", "face", face, faces);
  for (const auto& [edge, size] : options.sizes.edgeSizes)
    checkId("edge_sizes", "edge", edge, edges);
  for (const auto& [edge, points] : options.edgePoints) checkId("boundary", "edge", edge, edges);
  for (const geometry::LayerRequest& layers : options.layers) {
    for (const int edge : layers.edges) checkId("layers", "edge", edge, edges);
    for (const int face : layers.faces) checkId("layers", "face", face, faces);
  }
}

void bindModels(py::module_& module) {
  bindParts(module);
  bindFindings(module);
  py::class_<MeshableModel, std::shared_ptr<MeshableModel>>(module, "MeshableModel")
      .def_property_readonly("kind", &MeshableModel::kind)
      .def_property_readonly("notes", &MeshableModel::notes)
      .def_property_readonly("unit", &MeshableModel::unit)
      .def_property_readonly("file_unit", &MeshableModel::fileUnit)
      .def("parts", askedOf([](const MeshableModel& model, double size, const auto& call) {
             return model.parts(size, call);
           }))
      .def("defects", askedOf([](const MeshableModel& model, double size, const auto& call) {
             return model.defects(size, call);
           }))
      .def("named",
           [](const MeshableModel& model,
              const std::vector<std::pair<std::string, std::vector<int>>>& names) {
             return std::const_pointer_cast<MeshableModel>(model.named(names));
           })
      .def("contacts", &MeshableModel::contacts, py::call_guard<py::gil_scoped_release>());
  module.def("read", [](const std::filesystem::path& path) {
    return std::const_pointer_cast<MeshableModel>(readWithoutGil(path));
  });
  module.def("planar", [](const py::dict& domain) {
    return std::const_pointer_cast<MeshableModel>(planarModelFrom(domain));
  });
  module.def("triangles", [](const py::dict& surface) {
    return std::const_pointer_cast<MeshableModel>(trianglesFrom(surface));
  });
  module.def("surface", [](const py::dict& surface) {
    return std::const_pointer_cast<MeshableModel>(surfaceFrom(surface));
  });
  module.def("chart_names", &geometry::chartNames);
}

}  // namespace af2::python
