#include "geometry/check/sound_faces.h"

#include <algorithm>

#include "engine/base/parallel.h"
#include "engine/base/place_text.h"
#include "geometry/mesh/unused_vertices.h"

namespace af2::geometry {
namespace {

std::string describe(const MeshFinding& finding) {
  std::string text = "the mesh does not pass its checks: " + finding.what;
  const Point3& p = finding.place;
  if (p == Point3{}) return text;  // it is about the whole face
  return text + ", near " + textOf(p);
}

bool isOneOf(const std::vector<int>& sorted, int id) {
  return std::ranges::binary_search(sorted, id);
}

/// A face without width needs no elements if other faces have some. If no face has any, the size is
/// far too large, or the model is empty.
void failFacesWithoutElements(ModelMesh& mesh) {
  for (FaceReport& face : mesh.faces) {
    if (face.status != FaceStatus::Complete) continue;
    face.status = FaceStatus::Failed;
    face.reason += (face.reason.empty() ? "" : "; ");
    face.reason += "no part of the model is visible at this size; ask for a smaller one";
    face.cause = FailureCause::Size;
  }
}

}  // namespace

void dropElements(ModelMesh& mesh, const std::vector<int>& faces) {
  if (mesh.spooled) return dropSpooledFaces(mesh, faces);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    if (isOneOf(faces, mesh.face[i])) continue;
    mesh.elements[kept] = mesh.elements[i];
    mesh.face[kept] = mesh.face[i];
    mesh.origins[kept++] = mesh.origins[i];
  }
  mesh.elements.resize(kept);
  mesh.face.resize(kept);
  mesh.origins.resize(kept);
  dropUnusedVertices(mesh);
}

MeshFaults faultsOf(const ModelMesh& mesh, bool mayCross, int threads) {
  MeshFaults faults;
  forEachInParallel(2, threads, [&](std::size_t k) {
    if (k == 1)
      faults.findings = checkModelMesh(mesh, kMaxFindings, threads);
    else if (mayCross)
      faults.crossings = elementCrossings(mesh, [&](std::size_t count, const auto& work) {
        forEachInParallel(count, threads, work);
      });
  });
  return faults;
}

std::vector<std::string> keepSoundFaces(ModelMesh& mesh, const MeshFaults& faults) {
  std::vector<std::string> elsewhere;
  std::vector<int> bad;
  const auto giveUp = [&](const MeshFinding& finding) {
    const auto face = std::ranges::find(mesh.faces, finding.face, &FaceReport::id);
    if (face == mesh.faces.end()) {
      elsewhere.push_back(describe(finding));
      return;
    }
    if (isOneOf(bad, face->id)) return;
    bad.insert(std::ranges::upper_bound(bad, face->id), face->id);
    if (face->status == FaceStatus::Complete) face->status = FaceStatus::Failed;
    face->elements = 0;
    face->reason = describe(finding);
  };
  for (const MeshFinding& finding : faults.findings) giveUp(finding);
  for (const MeshFinding& finding : facesThatCross(faults.crossings, std::vector(bad)))
    giveUp(finding);
  if (!bad.empty()) dropElements(mesh, bad);
  if (elementCount(mesh) == 0) failFacesWithoutElements(mesh);
  return elsewhere;
}

}  // namespace af2::geometry
