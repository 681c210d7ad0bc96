#include "geometry/occ/faces/fault_reasons.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "engine/base/elementary.h"
#include "engine/base/place_text.h"
#include "geometry/mesh/blame_model.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/faces/crossed_edges.h"
#include "geometry/occ/faces/edge_sides.h"
#include "geometry/occ/faces/surface_faults.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

namespace {

double leastAngleOf(const ModelMesh& mesh, const Element& element) {
  const auto corners = element.vertices();
  const std::size_t count = corners.size();
  const auto at = [&](std::size_t i) { return mesh.vertices[corners[i % count].value]; };
  double least = std::numbers::pi;
  for (std::size_t i = 0; i < count; ++i) {
    const Point3 out = at(i + 1) - at(i), in = at(i + count - 1) - at(i);
    least = std::min(least, angleBetween(out, in));
  }
  return least;
}

/// Which faces have elements with an angle below half a degree, by id.
std::vector<bool> facesWithNeedles(const ModelMesh& mesh, std::size_t count) {
  constexpr double kNeedle = 0.5 * std::numbers::pi / 180;
  std::vector<bool> isAsked(count + 1, false), has(count + 1, false);
  for (const FaceReport& face : mesh.faces)
    isAsked[static_cast<std::size_t>(face.id)] = !face.attempts.empty();
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    const auto face = static_cast<std::size_t>(mesh.face[i]);
    if (isAsked[face] && !has[face] && leastAngleOf(mesh, mesh.elements[i]) < kNeedle)
      has[face] = true;
  }
  return has;
}

/// Words for a tip so sharp that the elements around it are needles; empty if there is none.
std::string needleTipOf(const FaceSurface& surface) {
  constexpr double kNeedle = 2.3 * std::numbers::pi / 180;  // four elements of half a degree
  for (const SharpTip& tip : surface.sharpTips()) {
    if (tip.angle >= kNeedle) continue;
    const double sine = tip.angle / (2 * std::numbers::pi);
    const double opening = 2 * angleOf({std::sqrt(1 - sine * sine), sine});
    return "it ends in a tip of " + af2::textOf(opening * 180 / std::numbers::pi, 2) +
           " degrees at " + af2::textOf(tip.position);
  }
  return "";
}

bool isUnexplained(const FaceReport& face) {
  return face.status == FaceStatus::Failed && face.cause == FailureCause::Unknown;
}

std::string turnedEdgeOf(const ModelShape& model, int face,
                         const std::map<int, std::vector<EdgeSide>>& sides) {
  for (const EdgeUse& use : model.edgesOfFaces[static_cast<std::size_t>(face) - 1]) {
    const auto found = sides.find(use.id);
    if (found == sides.end() || found->second.size() != 2) continue;
    const EdgeSide &one = found->second[0], &other = found->second[1];
    if (one.face == other.face || one.isForward != other.isForward) continue;
    return "in the model itself it runs along edge " + std::to_string(use.id) +
           " in the same direction as face " +
           std::to_string(one.face == face ? other.face : one.face) +
           ": one of them is turned inside out, or has a loop that is; export the model again";
  }
  return "";
}

}  // namespace

std::string faultOf(const ModelShape& model, int face, double size) {
  if (const auto crossed = crossedEdges(model, face)) return textOf(*crossed);
  if (const auto fault = surfaceFault(model, face, size)) return textOf(*fault);
  return "";
}

void tellOfFaults(const ModelShape& model, double size, ModelMesh& mesh) {
  constexpr int kMaxReported = 20;  // where many have faults, the first ones are enough
  const std::vector<bool> hasNeedles =
      facesWithNeedles(mesh, static_cast<std::size_t>(model.faces.Extent()));
  int examined = 0;
  for (FaceReport& face : mesh.faces) {
    const bool isFailed = isUnexplained(face);
    const bool isPoor =
        face.status == FaceStatus::Complete && hasNeedles[static_cast<std::size_t>(face.id)];
    if (!(isFailed || (isPoor && face.surfaceType != "plane"))) continue;
    if (++examined > kMaxReported) break;
    std::string cause = faultOf(model, face.id, size);
    if (isPoor && cause.empty()) cause = needleTipOf(model.surface(face.id));
    if (cause.empty()) continue;
    if (isFailed)
      blameModel(cause, face);
    else
      mesh.notes.push_back("face " + std::to_string(face.id) +
                           " has angles below half a degree: " + cause);
  }
}

void tellOfTurnedEdges(const ModelShape& model, std::vector<FaceReport>& faces) {
  if (std::ranges::none_of(faces, isUnexplained)) return;
  const std::map<int, std::vector<EdgeSide>> sides = sidesOfEdges(model);
  for (FaceReport& face : faces) {
    if (!isUnexplained(face)) continue;
    if (const std::string turned = turnedEdgeOf(model, face.id, sides); !turned.empty())
      blameModel(turned, face);
  }
}

}  // namespace af2::geometry
