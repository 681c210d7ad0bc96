#include "geometry/retry/protected_neighbors.h"

#include <algorithm>

#include "geometry/retry/retry_limits.h"

namespace af2::geometry {

namespace {

/// The face itself and those that share an edge with it.
std::vector<std::size_t> besideFace(const std::vector<std::vector<int>>& edgesOfFaces,
                                    std::size_t face) {
  const auto isEdgeOfIt = [&](int e) { return std::ranges::binary_search(edgesOfFaces[face], e); };
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < edgesOfFaces.size(); ++k)
    if (std::ranges::any_of(edgesOfFaces[k], isEdgeOfIt)) found.push_back(k);
  return found;
}

/// Whether there was a request to withdraw or to soften.
bool yields(Retrial& retrial, std::size_t culprit) {
  FaceRecord& record = retrial.faces[culprit];
  if (!record.wasBad) {
    retrial.requests.dropAll(culprit);
    return true;
  }
  if (record.softenings == kMaxSoftenings) return false;
  ++record.softenings;
  retrial.requests.soften(culprit, kSoftening);
  return true;
}

}  // namespace

bool isBad(const FaceMesh& mesh) { return failed(mesh) || mesh.diagnosis.hasBadAngle; }

void rememberBadFace(Retrial& retrial, const FaceMeshes& state, std::size_t face) {
  retrial.faces[face].wasBad = isBad(state.meshes[face]);
}

bool isSpoiledNeighbor(const Retrial& retrial, const FaceMeshes& next, std::size_t face) {
  return !retrial.faces[face].wasBad && isBad(next.meshes[face]);
}

std::optional<std::size_t> protectNeighbor(Retrial& retrial, FaceMeshes&, std::size_t face) {
  std::size_t count = 0;
  for (const std::size_t culprit : besideFace(retrial.model.edgesOfFaces(), face)) {
    if (!retrial.requests.has(culprit) || !yields(retrial, culprit)) continue;
    retrial.faces[culprit].isGivenUp = true;
    retrial.withdrawn.push_back(culprit);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return count;
}

}  // namespace af2::geometry
