#include "geometry/check/sounder_mesh.h"

#include <algorithm>
#include <utility>

namespace af2::geometry {
namespace {

std::size_t faultsOf(const ModelMesh& mesh) { return failedFaces(mesh) + mesh.findings.size(); }

}  // namespace

bool hasFaults(const ModelMesh& mesh) { return faultsOf(mesh) > 0; }

ModelMesh sounderMesh(ModelMesh healed, ModelMesh asItWas) {
  if (elementCount(asItWas) == 0 || faultsOf(asItWas) >= faultsOf(healed)) return healed;
  const auto failed = std::ranges::find(healed.faces, FaceStatus::Failed, &FaceReport::status);
  std::string cause = std::to_string(failedFaces(healed)) + " faces of the healed model failed";
  if (failed != healed.faces.end())
    cause += ", the first being face " + std::to_string(failed->id) + ": " + failed->reason;
  if (healed.healing) {
    asItWas.healing = Healing{healed.healing->tolerance, {}, std::move(healed.healing->undone)};
    asItWas.healing->undone.push_back(
        "the model was not healed, because the original can be meshed better: " + cause);
  }
  return asItWas;
}

}  // namespace af2::geometry
