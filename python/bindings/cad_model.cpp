// CAD models: as `af2 mesh` meshes them, but in the process of the caller.
#include <af2/engine/error.h>
#include <af2/geometry/contacts.h>
#include <af2/geometry/curves_inside.h>
#include <af2/geometry/defects.h>
#include <af2/geometry/edge_list.h>
#include <af2/geometry/fingerprint.h>
#include <af2/geometry/heal_model.h>
#include <af2/geometry/imprint.h>
#include <af2/geometry/measures.h>
#include <af2/geometry/mesh_merged.h>
#include <af2/geometry/mesh_model.h>
#include <af2/geometry/named_faces.h>
#include <af2/geometry/part_sizes.h>
#include <af2/geometry/periodic_faces.h>
#include <af2/geometry/points_inside.h>
#include <af2/geometry/points_on_model.h>
#include <af2/geometry/sounder_mesh.h>

#include <algorithm>
#include <mutex>

#include "python/bindings/model.h"

namespace af2::python {
namespace {

class CadPlaces final : public Places {
 public:
  explicit CadPlaces(geometry::Model model) : model_(std::move(model)) {}

  std::vector<FoundPoint> nearest(std::span<const Point3> points, std::span<const int> faces,
                                  int threads) const override {
    return converted(geometry::nearestPoints(model_, points, faces, threads));
  }
  std::vector<FoundPoint> at(int face, std::span<const Point2> parameters) const override {
    return converted(geometry::pointsAt(model_, face, parameters));
  }

 private:
  static std::vector<FoundPoint> converted(const std::vector<geometry::PointOnModel>& points) {
    std::vector<FoundPoint> found;
    found.reserve(points.size());
    for (const auto& [point, face, distance] : points) found.push_back({point, face, distance});
    return found;
  }

  geometry::Model model_;
};

geometry::Overlaps overlapsOf(const std::string& word) {
  if (word == "first") return geometry::Overlaps::First;
  if (word == "last") return geometry::Overlaps::Last;
  if (word == "cut") return geometry::Overlaps::Cut;
  return geometry::Overlaps::Refuse;
}

std::vector<std::string> namesOf(const geometry::Model& model) {
  std::vector<std::string> names;
  for (int face = 1; face <= model.faceCount(); ++face) names.push_back(model.faceName(face));
  return names;
}

int idOf(const FaceReference& face, const geometry::Model& model) {
  if (face.name.empty()) return face.id;
  const std::vector<int> faces = geometry::facesCalled(face.name, namesOf(model), model.groups());
  if (faces.size() == 1) return faces.front();
  const std::string many =
      faces.empty() ? "there is no face or group" : std::to_string(faces.size()) + " faces are";
  throw InputError("periodic: " + many + " called '" + face.name + "'");
}

geometry::Model prepared(const geometry::Model& asRead, const Request& request) {
  geometry::Model model = asRead;
  if (request.heal) model = geometry::healModel(asRead, {request.healTolerance});
  if (request.imprint || request.glue)
    model = geometry::imprintModel(model, {.tolerance = request.imprintTolerance,
                                           .overlaps = overlapsOf(request.overlap),
                                           .onlyEqual = request.glue,
                                           .stop = request.options.stop});
  return model;
}

geometry::Model withInside(const geometry::Model& model, const Request& request) {
  return geometry::withCurvesInside(geometry::withPointsInside(model, request.points),
                                    request.curves);
}

geometry::ModelMesh meshed(const geometry::Model& model, const Request& request,
                           const AF2Algorithm& algorithm) {
  geometry::MeshingOptions options = request.options;
  options.faces = geometry::withFacesCalled(std::move(options.faces), options.faceNames,
                                            namesOf(model), model.groups());
  options.faceNames.clear();
  geometry::PeriodicRequest periodic{request.periodicDirections, {}};
  for (const auto& [first, second] : request.periodicPairs)
    periodic.pairs.emplace_back(idOf(first, model), idOf(second, model));
  if (periodic.isAsked())
    return geometry::meshPeriodic(model, algorithm, options,
                                  geometry::findPeriodic(model, periodic), request.merge);
  return request.merge ? geometry::meshMerged(model, algorithm, options, *request.merge)
                       : geometry::meshModel(model, algorithm, options);
}

class CadModel final : public MeshableModel {
 public:
  explicit CadModel(geometry::Model model) : model_(std::move(model)) {}

  const char* kind() const override { return "cad"; }
  std::vector<std::string> notes() const override { return model_.notes(); }
  std::string unit() const override { return model_.unit(); }
  std::string fileUnit() const override { return model_.fileUnit(); }

  Meshed mesh(const Request& request, const AF2Algorithm& algorithm) const override {
    geometry::Model model = withInside(prepared(model_, request), request);
    checkIds(request, model.faceCount(), model.edgeCount());
    geometry::ModelMesh mesh = meshed(model, request, algorithm);
    const bool isImprinted = request.imprint || request.glue;
    if (request.heal && !isImprinted && geometry::hasFaults(mesh) && !request.asksByNumber() &&
        !request.options.stop.stop_requested())
      chooseSounder(request, algorithm, model, mesh);
    if (isImprinted && mesh.imprinting && !mesh.imprinting->undone.empty())
      mesh.findings.push_back("the parts of the model were not made to share faces: " +
                              mesh.imprinting->undone);
    return {std::move(mesh), std::make_shared<const CadPlaces>(std::move(model))};
  }

  Parts parts(double, const std::shared_ptr<Call>&) const override {
    Parts parts;
    const auto measures = geometry::measuresOfFaces(model_);
    for (int id = 1; id <= model_.faceCount(); ++id) {
      FaceEntry face{id, model_.faceName(id), model_.surfaceType(id), 0, {}};
      if (const auto& own = measures[static_cast<std::size_t>(id) - 1]) {
        face.area = own->area;
        face.edges = own->edges;
      }
      parts.faces.push_back(std::move(face));
    }
    parts.edges = geometry::edgesOf(model_);
    parts.groups = model_.groups();
    return parts;
  }

  std::vector<geometry::Defect> defects(double size, const std::shared_ptr<Call>&) const override {
    return geometry::findDefects(model_, size > 0 ? size : model_.diagonal() / 100);
  }
  geometry::PartContacts contacts() const override { return geometry::findContacts(model_); }
  std::shared_ptr<const MeshableModel> named(
      const std::vector<std::pair<std::string, std::vector<int>>>& names) const override {
    std::vector<geometry::NamedFaces> all;
    for (const auto& [name, faces] : names) all.push_back({name, faces});
    return std::make_shared<const CadModel>(geometry::withNames(model_, all));
  }

 private:
  /// Repairs that are valid by themselves may still leave faces that cannot be meshed.
  void chooseSounder(const Request& request, const AF2Algorithm& algorithm, geometry::Model& model,
                     geometry::ModelMesh& mesh) const {
    const geometry::Model asItWas = withInside(model_, request);
    const std::string healed = geometry::fingerprint(mesh);
    mesh = geometry::sounderMesh(std::move(mesh), meshed(asItWas, request, algorithm));
    if (geometry::fingerprint(mesh) != healed) model = asItWas;
  }

  geometry::Model model_;
};

/// OpenCASCADE's readers share global state.
std::mutex& readers() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

ModelPointer cadModelFrom(const std::filesystem::path& path) {
  const std::lock_guard lock(readers());
  return std::make_shared<const CadModel>(geometry::readModel(path));
}

}  // namespace af2::python
