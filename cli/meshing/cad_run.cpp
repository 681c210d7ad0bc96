// `af2 mesh` for CAD models.
#include <fmt/core.h>

#include <algorithm>
#include <numeric>

#include "cli/meshing/imprinted_model.h"
#include "cli/meshing/mesh_summary.h"
#include "cli/meshing/model_runs.h"
#include "cli/program/progress_bar.h"
#include "cli/program/usage_error.h"
#include "geometry/check/sounder_mesh.h"
#include "geometry/meshing/part_sizes.h"
#include "geometry/occ/assembly/contacts.h"
#include "geometry/occ/heal/heal_model.h"
#include "geometry/occ/merge/mesh_merged.h"
#include "geometry/occ/model/curves_inside.h"
#include "geometry/occ/model/points_inside.h"
#include "geometry/occ/periodic/periodic_faces.h"
#include "geometry/occ/run/mesh_model.h"

namespace af2::cli {
namespace {

/// Meshes all requested faces except those given up, which are reported as failed.
std::vector<int> withoutGivenUp(std::vector<int> faces, const geometry::Model& model,
                                const GivenUp& givenUp) {
  if (givenUp.empty()) return faces;
  if (faces.empty()) {
    faces.resize(static_cast<std::size_t>(model.faceCount()));
    std::iota(faces.begin(), faces.end(), 1);
  }
  std::erase_if(faces, [&](int face) { return givenUp.contains(face); });
  return faces;
}

void reportGivenUp(const geometry::Model& model, const GivenUp& givenUp,
                   geometry::ModelMesh& mesh) {
  for (const auto& [id, reason] : givenUp) {
    if (id > model.faceCount()) continue;  // a face of the model before healing
    geometry::FaceReport report;
    report.id = id;
    report.name = model.faceName(id);
    report.surfaceType = model.surfaceType(id);
    report.status = geometry::FaceStatus::Failed;
    report.reason = reason;
    const auto place = std::ranges::upper_bound(mesh.faces, id, {}, &geometry::FaceReport::id);
    mesh.faces.insert(place, report);
  }
}

std::vector<std::string> namesOf(const geometry::Model& model) {
  std::vector<std::string> names;
  for (int face = 1; face <= model.faceCount(); ++face) names.push_back(model.faceName(face));
  return names;
}

int faceCalled(const PeriodicFace& face, const geometry::Model& model) {
  if (face.name.empty()) return face.id;
  const std::vector<int> faces = geometry::facesCalled(face.name, namesOf(model), model.groups());
  if (faces.size() != 1)
    throw UsageError(fmt::format(
        "--periodic: {} called '{}' (see af2 inspect)",
        faces.empty() ? "there is no face or group" : std::to_string(faces.size()) + " faces are",
        face.name));
  return faces.front();
}

std::vector<std::pair<int, int>> pairsByNumber(const PeriodicFaces& asked,
                                               const geometry::Model& model) {
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [first, second] : asked.pairs)
    pairs.emplace_back(faceCalled(first, model), faceCalled(second, model));
  return pairs;
}

geometry::ModelMesh meshAll(const MeshRequest& request, const geometry::Model& model,
                            geometry::MeshingOptions options, const AF2Algorithm& algorithm,
                            const GivenUp& givenUp) {
  options.faces =
      withFacesCalled(std::move(options.faces), options.faceNames, namesOf(model), model.groups());
  options.faceNames.clear();
  const geometry::PeriodicRequest periodic{request.periodic.directions,
                                           pairsByNumber(request.periodic, model)};
  if (periodic.isAsked() && givenUp.empty())
    return geometry::meshPeriodic(
        model, algorithm, options, geometry::findPeriodic(model, periodic),
        request.merge.isAsked ? std::optional(request.merge.request) : std::nullopt);
  options.faces = withoutGivenUp(std::move(options.faces), model, givenUp);
  geometry::ModelMesh mesh;
  if (!options.faces.empty() || givenUp.empty())
    mesh = request.merge.isAsked
               ? geometry::meshMerged(model, algorithm, options, request.merge.request)
               : geometry::meshModel(model, algorithm, options);
  reportGivenUp(model, givenUp, mesh);
  if (periodic.isAsked())
    mesh.findings.push_back(
        "no faces were made periodic, because a face of the model was given up");
  return mesh;
}

geometry::Model withInside(const geometry::Model& model, const geometry::InsideFaces& inside) {
  return geometry::withCurvesInside(geometry::withPointsInside(model, inside.points),
                                    inside.curves);
}

/// For a note, which must cost little: for all pairs of a large assembly there is `af2 inspect`.
geometry::PartContacts contactsToTell(const MeshRequest& request, const geometry::Model& model) {
  if (request.quiet && request.report.empty()) return {};  // nobody is told
  if (!request.options.faces.empty() || !request.options.faceNames.empty())
    return {};  // the other parts are not meshed
  if (request.imprint.isAsked && !request.imprint.onlyEqual && model.imprinting()->undone.empty())
    return {};  // parts share what they have in common
  geometry::ContactOptions options;
  options.maxFaces = 50;
  options.secondsForPair = 2;
  options.seconds = 5;
  return geometry::findContacts(model, options);
}

}  // namespace

geometry::ModelMesh runCad(const MeshRequest& request, const AF2Algorithm& algorithm,
                           const RunControl& control) {
  ProgressBar bar(control.showProgress);
  bar.show("reading", 0, request.model.filename().string());
  Stopwatch reading;
  const geometry::Model asRead = geometry::readModel(request.model);
  geometry::Model model = asRead;
  if (request.heal) {
    bar.show("healing", 0, request.model.filename().string());
    model = geometry::healModel(asRead, {request.healTolerance});
  }
  if (request.imprint.isAsked) {
    bar.show("imprinting", 0, request.model.filename().string());
    model = imprintedModel(model, request.imprint, control.stop());
  }
  model = withInside(model, request.inside);
  const double readSeconds = reading.seconds();
  const Stopwatch comparing;
  geometry::PartContacts contacts;
  if (!control.stop().stop_requested()) contacts = contactsToTell(request, model);
  const double contactSeconds = contacts.parts > 1 ? comparing.seconds() : 0;
  checkUnit(request.scale, model.unit());
  checkIds(request, model.faceCount(), model.edgeCount());
  if (control.names) control.names(namesOf(model), model.groups());
  const GivenUp givenUp = control.givenUp ? *control.givenUp : GivenUp();
  const auto meshed = [&](const geometry::Model& some, int firstFace) {
    return meshAll(request, some, optionsOf(request, control, bar, firstFace), algorithm,
                   firstFace == 0 ? givenUp : GivenUp());
  };
  geometry::ModelMesh mesh = meshed(model, 0);
  // Faces of the unhealed model are numbered after these. If one of them was given up, the unhealed
  // model is not tried again.
  const int last = model.faceCount();
  if (request.heal && !request.imprint.isAsked && geometry::hasFaults(mesh) &&
      !request.asksByNumber() && !control.stop().stop_requested() &&
      givenUp.upper_bound(last) == givenUp.end())
    mesh = geometry::sounderMesh(std::move(mesh), meshed(withInside(asRead, request.inside), last));
  if (!request.healingEnd.empty())
    mesh.healing =
        geometry::Healing{request.healTolerance,
                          {},
                          {"the repairs were left out: when tried, " + request.healingEnd}};
  if (!request.imprint.end.empty())
    mesh.imprinting =
        geometry::Imprinting{request.imprint.tolerance, 0, 0, {}, request.imprint.end};
  if (const std::string fault = imprintFault(mesh.imprinting); !fault.empty())
    mesh.findings.push_back(fault);
  mesh.contacts = contacts;
  mesh.seconds.read = readSeconds;
  mesh.seconds.contacts = contactSeconds;
  return mesh;
}

}  // namespace af2::cli
