// A mesh as Python holds it: arrays over its data, measures, files.
#include <af2/engine/error.h>
#include <af2/geometry/element_scores.h>
#include <af2/geometry/fingerprint.h>
#include <af2/geometry/mesh_files.h>
#include <af2/geometry/quality.h>
#include <af2/geometry/report.h>
#include <af2/geometry/scaled_mesh.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <string>

#include "python/bindings/model.h"
#include "python/bindings/rules.h"

namespace af2::python {
namespace {

using geometry::ModelMesh;

class MeshData {
 public:
  MeshData(Meshed meshed, std::shared_ptr<const Rules> rules, std::string name,
           std::shared_ptr<Call> call, int threads)
      : mesh_(std::move(meshed.mesh)),
        places_(std::move(meshed.places)),
        rules_(std::move(rules)),
        call_(std::move(call)),
        threads_(threads) {
    mesh_.name = std::move(name);
    mesh_.ruleTexts = rules_->texts();
    constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
    if (mesh_.vertices.size() > kMost)
      throw InputError("the mesh has more vertices than arrays of 32-bit numbers can index");
  }

  const ModelMesh& mesh() const { return mesh_; }
  const Places& places() const { return *places_; }
  /// The call that made the mesh: surfaces of Python report errors to it.
  Call& call() const { return *call_; }
  std::size_t quads() const {
    return static_cast<std::size_t>(std::ranges::count_if(mesh_.elements, &Element::isQuad));
  }

  /// Both are computed at the first request.
  const std::vector<float>& scores() {
    std::call_once(scored_, [&] {
      mesh_.scores = geometry::elementScores(mesh_, rules_->ruleSet().definition(), threads_);
    });
    return mesh_.scores;
  }
  const std::vector<double>& qualities() {
    std::call_once(measured_, [&] {
      qualities_.reserve(mesh_.elements.size());
      for (const Element& element : mesh_.elements)
        qualities_.push_back(geometry::shapeQuality(mesh_.vertices, element));
    });
    return qualities_;
  }

  void write(const std::filesystem::path& file, const geometry::FileOptions& options,
             double factor) {
    if (mesh_.elements.empty())
      throw InputError(file.string() + ": the mesh is empty, so no file is written");
    if (geometry::meshFormatOf(file).holdsScores) scores();
    if (factor == 1)
      geometry::writeMesh(mesh_, file, options);
    else
      geometry::writeMesh(geometry::scaledMesh(mesh_, factor), file, options);
  }

 private:
  ModelMesh mesh_;
  std::shared_ptr<const Places> places_;
  std::shared_ptr<const Rules> rules_;
  std::shared_ptr<Call> call_;
  int threads_;
  std::once_flag scored_, measured_;
  std::vector<double> qualities_;
};

const ModelMesh& meshOf(const py::object& self) { return self.cast<const MeshData&>().mesh(); }

/// Ids are unsigned in C++ and signed in Python, where -1 means none.
py::array idView(const py::object& self, const void* data, py::ssize_t rows, py::ssize_t columns,
                 std::size_t stride) {
  return viewOf(self, static_cast<const std::int32_t*>(data), {rows, columns},
                {static_cast<py::ssize_t>(stride), sizeof(std::int32_t)});
}

py::array points(const py::object& self) {
  const auto& vertices = meshOf(self).vertices;
  return viewOf(self, reinterpret_cast<const double*>(vertices.data()),
                {static_cast<py::ssize_t>(vertices.size()), 3}, {sizeof(Point3), sizeof(double)});
}

py::array corners(const py::object& self, py::ssize_t columns) {
  const auto& elements = meshOf(self).elements;
  return idView(self, elements.data(), static_cast<py::ssize_t>(elements.size()), columns,
                sizeof(Element));
}

py::array midsides(const py::object& self) {
  const auto& midsides = meshOf(self).midsides;
  return idView(self, midsides.data(), static_cast<py::ssize_t>(midsides.size()), 4,
                sizeof(midsides.front()));
}

py::array segments(const py::object& self) {
  const auto& all = meshOf(self).segments;
  return idView(self, all.data(), static_cast<py::ssize_t>(all.size()), 2,
                sizeof(geometry::EdgeSegment));
}

template <class T>
py::array listView(const py::object& self, const std::vector<T>& values) {
  return viewOf(self, values.data(), {static_cast<py::ssize_t>(values.size())}, {sizeof(T)});
}

py::array straightened(const py::object& self) {
  const auto& elements = meshOf(self).straightened;
  return viewOf(self, reinterpret_cast<const std::int32_t*>(elements.data()),
                {static_cast<py::ssize_t>(elements.size())}, {sizeof(ElementId)});
}

py::array scores(const py::object& self) {
  auto& data = self.cast<MeshData&>();
  {
    const py::gil_scoped_release noGil;
    data.scores();
  }
  return listView(self, data.mesh().scores);
}

py::array qualities(const py::object& self) {
  auto& data = self.cast<MeshData&>();
  {
    const py::gil_scoped_release noGil;
    data.qualities();
  }
  return listView(self, data.qualities());
}

py::tuple found(const std::vector<FoundPoint>& found) {
  std::vector<Point3> positions, normals;
  std::vector<std::int32_t> faces;
  std::vector<double> distances;
  py::array_t<double> parameters(
      std::vector<py::ssize_t>{static_cast<py::ssize_t>(found.size()), 2});
  auto uv = parameters.mutable_unchecked<2>();
  for (const FoundPoint& point : found) {
    const auto row = static_cast<py::ssize_t>(positions.size());
    uv(row, 0) = point.point.u;
    uv(row, 1) = point.point.v;
    positions.push_back(point.point.position);
    normals.push_back(point.point.normal);
    faces.push_back(point.face);
    distances.push_back(point.distance);
  }
  return py::make_tuple(arrayOf(positions), arrayOf(normals), arrayOf(faces), parameters,
                        arrayOf(distances));
}

/// On a thread of its own, because a surface of Python is asked for its points.
py::tuple snap(const MeshData& data, const py::object& places, const std::vector<int>& faces,
               int threads) {
  const std::vector<Point3> points = points3(places, "points");
  std::vector<FoundPoint> nearest;
  data.call().run([&] { nearest = data.places().nearest(points, faces, threads); });
  return found(nearest);
}

py::tuple pointsOfFace(const MeshData& data, int face, const py::object& parameters) {
  const std::vector<Point2> uv = points2(parameters, "uv");
  std::vector<FoundPoint> points;
  data.call().run([&] { points = data.places().at(face, uv); });
  return found(points);
}

geometry::FileOptions fileOptions(bool lines, const std::vector<std::string>& groups,
                                  bool isCompressed) {
  geometry::FileOptions options;
  if (lines) options.lines = geometry::LinesAlong::AllEdges;
  options.compress = isCompressed;
  for (const std::string& word : groups) {
    std::string known;
    bool isKnown = false;
    for (const auto& [name, grouping] : geometry::groupings()) {
      known += (known.empty() ? "" : ", ") + std::string(name);
      if (name != word) continue;
      options.groups.push_back(grouping);
      isKnown = true;
    }
    if (!isKnown)
      throw InputError("groups: '" + word + "' is no kind of group; there are " + known);
  }
  return options;
}

void writeReport(MeshData& data, const std::filesystem::path& path, const std::string& reason) {
  geometry::RunReport report;
  report.status = geometry::statusOf(data.mesh());
  report.reason = reason;
  if (!reason.empty() && report.status == geometry::RunStatus::Complete)
    report.status = geometry::RunStatus::Partial;
  report.quality = geometry::measureQuality(data.mesh(), 0);
  geometry::writeReport(report, data.mesh(), path);
}

std::shared_ptr<MeshData> mesh(const ModelPointer& model, const std::shared_ptr<const Rules>& rules,
                               const py::dict& asked, std::string name) {
  if (rules->algorithm() == nullptr) throw InputError("the rule file has no rule set");
  const auto call = std::make_shared<Call>();
  const Request request = requestFrom(asked, call);
  Meshed meshed;
  call->run([&] { meshed = model->mesh(request, *rules->algorithm()); });
  return std::make_shared<MeshData>(std::move(meshed), rules, std::move(name), call,
                                    request.options.threads);
}

void bindArrays(py::class_<MeshData, std::shared_ptr<MeshData>>& bound) {
  bound.def_property_readonly("points", &points)
      .def_property_readonly("elements", [](const py::object& self) { return corners(self, 4); })
      .def_property_readonly("first_corners",
                             [](const py::object& self) { return corners(self, 3); })
      .def_property_readonly("midsides", &midsides)
      .def_property_readonly("straightened", &straightened)
      .def_property_readonly("segments", &segments)
      .def_property_readonly("segment_edges",
                             [](const py::object& self) {
                               return memberView(self, meshOf(self).segments,
                                                 &geometry::EdgeSegment::edge);
                             })
      .def_property_readonly("segment_uses",
                             [](const py::object& self) {
                               return memberView(self, meshOf(self).segments,
                                                 &geometry::EdgeSegment::uses);
                             })
      .def_property_readonly(
          "face", [](const py::object& self) { return listView(self, meshOf(self).face); })
      .def_property_readonly("rule",
                             [](const py::object& self) {
                               return memberView(self, meshOf(self).origins, &ElementOrigin::rule);
                             })
      .def_property_readonly("level",
                             [](const py::object& self) {
                               return memberView(self, meshOf(self).origins, &ElementOrigin::level);
                             })
      .def_property_readonly("changed",
                             [](const py::object& self) {
                               return memberView(self, meshOf(self).origins,
                                                 &ElementOrigin::isChanged);
                             })
      .def_property_readonly(
          "wanted_sizes",
          [](const py::object& self) { return listView(self, meshOf(self).wantedSizes); })
      .def_property_readonly("scores", &scores)
      .def_property_readonly("quality", &qualities);
}

}  // namespace

void bindMesh(py::module_& module) {
  py::class_<MeshData, std::shared_ptr<MeshData>> bound(module, "MeshData");
  bindArrays(bound);
  bound.def_property_readonly("quads", &MeshData::quads)
      .def_property_readonly("mesh", &MeshData::mesh, py::return_value_policy::reference_internal)
      .def_property_readonly(
          "fingerprint", [](const MeshData& data) { return geometry::fingerprint(data.mesh()); })
      .def_property_readonly("status",
                             [](const MeshData& data) {
                               return std::string(toString(geometry::statusOf(data.mesh())));
                             })
      .def_property_readonly(
          "measures", [](const MeshData& data) { return geometry::measureQuality(data.mesh(), 0); })
      .def("snap", &snap)
      .def("evaluate", &pointsOfFace)
      .def(
          "write",
          [](MeshData& data, const std::filesystem::path& file, bool allLines,
             const std::vector<std::string>& groups, bool isCompressed, double factor) {
            data.write(file, fileOptions(allLines, groups, isCompressed), factor);
          },
          py::call_guard<py::gil_scoped_release>())
      .def("write_report", &writeReport, py::call_guard<py::gil_scoped_release>());
  module.def("mesh", &mesh);
  module.def("length_units", [] {
    py::dict units;
    for (const geometry::LengthUnit& unit : geometry::lengthUnits())
      units[unit.name] = unit.perMillimetre;
    return units;
  });
  module.def("mesh_formats", [] {
    py::list formats;
    for (const geometry::MeshFormat& format : geometry::meshFormats())
      formats.append(py::make_tuple(std::string(format.extension), std::string(format.name)));
    return formats;
  });
}

}  // namespace af2::python
