// What is known of a mesh besides its elements, as objects of Python.
#include <af2/geometry/meshing_options.h>
#include <af2/geometry/model_mesh.h>
#include <af2/geometry/quality.h>
#include <af2/geometry/report.h>

#include <string>

#include "python/bindings/common.h"

namespace af2::python {
namespace {

using geometry::FaceReport;
using geometry::ModelMesh;

py::tuple tupleOf(const Point3& p) { return py::make_tuple(p.x, p.y, p.z); }

/// A property that reads a point as a tuple.
template <class Class>
auto place(Point3 Class::*member) {
  return [member](const Class& object) { return tupleOf(object.*member); };
}

void bindPlaces(py::module_& module) {
  using geometry::StuckPlace;
  py::class_<StuckPlace>(module, "StuckPlace")
      .def_property_readonly("start", place(&StuckPlace::from))
      .def_property_readonly("end", place(&StuckPlace::to))
      .def_property_readonly("uv", [](const StuckPlace& s) { return py::make_tuple(s.u, s.v); })
      .def_readonly("level", &StuckPlace::level)
      .def_property_readonly("refusals", [](const StuckPlace& s) {
        std::vector<std::pair<int, std::string>> refusals;
        for (const auto& [rule, reason] : s.refusals) refusals.emplace_back(rule, toString(reason));
        return refusals;
      });
  using geometry::LayersAlongEdge;
  py::class_<LayersAlongEdge>(module, "LayersAlongEdge")
      .def_readonly("edge", &LayersAlongEdge::edge)
      .def_readonly("asked", &LayersAlongEdge::asked)
      .def_readonly("fewest", &LayersAlongEdge::fewest)
      .def_readonly("most", &LayersAlongEdge::most)
      .def_readonly("segments", &LayersAlongEdge::segments)
      .def_readonly("fewer", &LayersAlongEdge::fewer)
      .def_readonly("thinner", &LayersAlongEdge::thinner)
      .def_readonly("thinnest", &LayersAlongEdge::thinnest)
      .def_property_readonly("place", place(&LayersAlongEdge::place));
  py::class_<FaceReport::OddLoop>(module, "OddLoop")
      .def_readonly("loop", &FaceReport::OddLoop::loop)
      .def_readonly("segments", &FaceReport::OddLoop::segments);
}

template <class Counts>
py::dict dictOf(const Counts& counts) {
  py::dict values;
  counts.forEach([&](const char* name, std::size_t count) { values[name] = count; });
  return values;
}

void bindFaces(py::module_& module) {
  py::class_<FaceReport>(module, "FaceReport")
      .def_readonly("id", &FaceReport::id)
      .def_readonly("name", &FaceReport::name)
      .def_readonly("surface", &FaceReport::surfaceType)
      .def_readonly("chart", &FaceReport::chart)
      .def_property_readonly("status",
                             [](const FaceReport& f) { return std::string(toString(f.status)); })
      .def_readonly("elements", &FaceReport::elements)
      .def_readonly("seconds", &FaceReport::seconds)
      .def_readonly("area", &FaceReport::area)
      .def_readonly("reason", &FaceReport::reason)
      .def_property_readonly("cause",
                             [](const FaceReport& f) { return std::string(toString(f.cause)); })
      .def_readonly("attempts", &FaceReport::attempts)
      .def_readonly("stuck", &FaceReport::stuck)
      .def_property_readonly("without_rule",
                             [](const FaceReport& f) {
                               py::dict counts;
                               counts["closing"] = f.withoutRule.closing;
                               counts["fan"] = f.withoutRule.fan;
                               counts["leaning"] = f.withoutRule.leaning;
                               return counts;
                             })
      .def_property_readonly("acts", [](const FaceReport& f) { return dictOf(f.acts); })
      .def_readonly("layers", &FaceReport::layers)
      .def_readonly("layer_elements", &FaceReport::layerElements)
      .def_readonly("odd_loops", &FaceReport::oddLoops)
      .def_readonly("triangles", &FaceReport::triangles)
      .def_property_readonly("first_triangle", place(&FaceReport::firstTriangle))
      .def_readonly("deviation", &FaceReport::deviation)
      .def_readonly("congruent_to", &FaceReport::congruentTo)
      .def("__repr__", [](const FaceReport& f) {
        return "<face " + std::to_string(f.id) + (f.name.empty() ? "" : " '" + f.name + "'") +
               " (" + f.surfaceType + "): " + toString(f.status) + ", " +
               std::to_string(f.elements) + " elements>";
      });
  using geometry::FaceGroup;
  py::class_<FaceGroup>(module, "FaceGroup")
      .def_readonly("name", &FaceGroup::name)
      .def_property_readonly("kind",
                             [](const FaceGroup& g) { return std::string(toString(g.kind)); })
      .def_readonly("faces", &FaceGroup::faces)
      .def_readonly("inward", &FaceGroup::inward);
  using geometry::EdgeGroup;
  py::class_<EdgeGroup>(module, "EdgeGroup")
      .def_property_readonly("name", [](const EdgeGroup& g) { return geometry::shownName(g); })
      .def_readonly("number", &EdgeGroup::number)
      .def_readonly("edges", &EdgeGroup::edges);
}

void bindChanges(py::module_& module) {
  using geometry::Healing, geometry::Imprinting, geometry::Merging, geometry::MergedGroup;
  py::class_<geometry::HealedChange>(module, "HealedChange")
      .def_readonly("what", &geometry::HealedChange::what)
      .def_readonly("count", &geometry::HealedChange::count)
      .def_property_readonly("place", [](const geometry::HealedChange& change) -> py::object {
        if (!change.place) return py::none();
        return tupleOf(*change.place);
      });
  py::class_<Healing>(module, "Healing")
      .def_readonly("tolerance", &Healing::tolerance)
      .def_readonly("changes", &Healing::changes)
      .def_readonly("undone", &Healing::undone);
  py::class_<Imprinting>(module, "Imprinting")
      .def_readonly("tolerance", &Imprinting::tolerance)
      .def_readonly("parts", &Imprinting::parts)
      .def_readonly("interfaces", &Imprinting::interfaces)
      .def_readonly("changes", &Imprinting::changes)
      .def_readonly("undone", &Imprinting::undone);
  py::class_<MergedGroup>(module, "MergedGroup")
      .def_readonly("faces", &MergedGroup::faces)
      .def_readonly("smooth_edges", &MergedGroup::smoothEdges)
      .def_readonly("narrow_edges", &MergedGroup::narrowEdges)
      .def_readonly("deviation", &MergedGroup::deviation);
  py::class_<Merging::Kept>(module, "KeptFace")
      .def_readonly("face", &Merging::Kept::face)
      .def_readonly("reason", &Merging::Kept::reason);
  py::class_<Merging>(module, "Merging")
      .def_readonly("angle", &Merging::angle)
      .def_readonly("narrow", &Merging::narrow)
      .def_readonly("groups", &Merging::groups)
      .def_readonly("vertices", &Merging::vertices)
      .def_readonly("chains", &Merging::chains)
      .def_readonly("kept", &Merging::kept);
}

void bindResults(py::module_& module) {
  using geometry::Deviation, geometry::PeriodicPair, geometry::StageSeconds;
  py::class_<Deviation>(module, "Deviation")
      .def_readonly("largest", &Deviation::largest)
      .def_property_readonly("place", place(&Deviation::place))
      .def_readonly("face", &Deviation::face)
      .def_readonly("edge", &Deviation::edge);
  py::class_<PeriodicPair>(module, "PeriodicPair")
      .def_readonly("first", &PeriodicPair::first)
      .def_readonly("second", &PeriodicPair::second)
      .def_property_readonly("transform",
                             [](const PeriodicPair& pair) {
                               return py::array_t<double>({4, 4}, pair.transform.data());
                             })
      .def_property_readonly("vertices", [](const PeriodicPair& pair) {
        static_assert(sizeof(pair.vertices.front()) == 2 * sizeof(std::int32_t));
        return py::array_t<std::int32_t>(
            {static_cast<py::ssize_t>(pair.vertices.size()), py::ssize_t{2}},
            reinterpret_cast<const std::int32_t*>(pair.vertices.data()));
      });
  py::class_<StageSeconds>(module, "StageSeconds")
      .def_readonly("edges", &StageSeconds::edges)
      .def_readonly("surface", &StageSeconds::surface)
      .def_readonly("optimize", &StageSeconds::optimize);
  using geometry::MeshQuality, geometry::LengthRatio;
  py::class_<MeshQuality>(module, "MeshQuality")
      .def_readonly("min", &MeshQuality::min)
      .def_readonly("p1", &MeshQuality::p1)
      .def_readonly("mean", &MeshQuality::mean)
      .def_readonly("worst_face", &MeshQuality::worstFace)
      .def_property_readonly("worst_place", place(&MeshQuality::worstPlace))
      .def_readonly("min_angle", &MeshQuality::minAngle)
      .def_readonly("max_angle", &MeshQuality::maxAngle)
      .def_readonly("free_edges", &MeshQuality::freeEdges)
      .def_property_readonly("edge_ratio", [](const MeshQuality& q) {
        py::dict ratio;
        ratio["mean"] = q.edges.mean;
        ratio["p5"] = q.edges.p5;
        ratio["p95"] = q.edges.p95;
        ratio["bounds"] = LengthRatio::kBounds;
        ratio["histogram"] = q.edges.histogram;
        return ratio;
      });
  using geometry::ModelProgress;
  py::class_<ModelProgress>(
      module, "Progress",
      "How far a mesh is: work_done of work_total, in expected elements; fraction; "
      "faces_done of faces; elements so far.")
      .def_readonly("work_done", &ModelProgress::workDone)
      .def_readonly("work_total", &ModelProgress::workTotal)
      .def_readonly("faces_done", &ModelProgress::facesDone)
      .def_readonly("faces", &ModelProgress::faces)
      .def_readonly("elements", &ModelProgress::elements)
      .def_property_readonly("fraction", [](const ModelProgress& progress) {
        return progress.workTotal > 0 ? progress.workDone / progress.workTotal : 0;
      });
}

}  // namespace

void bindReports(py::module_& module) {
  bindPlaces(module);
  bindFaces(module);
  bindChanges(module);
  bindResults(module);
  py::class_<ModelMesh>(module, "ModelMesh")
      .def_readonly("name", &ModelMesh::name)
      .def_readonly("faces", &ModelMesh::faces)
      .def_readonly("groups", &ModelMesh::groups)
      .def_readonly("boundaries", &ModelMesh::boundaries)
      .def_readonly("rule_names", &ModelMesh::ruleNames)
      .def_readonly("unit", &ModelMesh::unit)
      .def_readonly("file_unit", &ModelMesh::fileUnit)
      .def_readonly("notes", &ModelMesh::notes)
      .def_readonly("findings", &ModelMesh::findings)
      .def_readonly("healing", &ModelMesh::healing)
      .def_readonly("imprinting", &ModelMesh::imprinting)
      .def_readonly("merging", &ModelMesh::merging)
      .def_readonly("deviation", &ModelMesh::deviation)
      .def_readonly("periodic", &ModelMesh::periodic)
      .def_readonly("seconds", &ModelMesh::seconds);
}

}  // namespace af2::python
