#include "geometry/retry/last_tries.h"

#include <algorithm>
#include <utility>

#include "geometry/retry/retry_limits.h"

namespace af2::geometry {

namespace {

/// Each of the faces that are left may take its part, or a little in any case.
std::size_t candidatesFor(double left, double faces) {
  return static_cast<std::size_t>(std::min(left, std::max(kMinBudgetForLastTry, left / faces)));
}

bool isOfUse(const FaceMesh& mesh, const DividedEdges& divided) {
  return !failed(mesh) && !mesh.elements.empty() && !reachesTooFar(mesh, divided);
}

/// Keeps the failed face, so that it can be restored.
std::optional<std::size_t> meshAgain(Retrial& retrial, FaceMeshes& state, std::size_t face,
                                     TryLimits limits) {
  const double left = retrial.budget.left();
  if (left <= 0) {
    retrial.hasBudgetLeft = false;
    return std::nullopt;
  }
  const auto first = state.meshes.begin() + static_cast<std::ptrdiff_t>(face);
  const auto faces = static_cast<double>(std::count_if(first, state.meshes.end(), failed));
  FaceMesh was = std::move(state.meshes[face]);
  limits.failedBefore = true;
  limits.maxCandidates = candidatesFor(left, faces);
  retrial.model.mesh(face, retrial.options.sizes, limits, state);
  FaceMesh& mesh = state.meshes[face];
  retrial.budget.charge(mesh);
  if (!isOfUse(mesh, state.divided)) {
    mesh = std::move(was);
    return std::nullopt;
  }
  mesh.history = was.history;
  mesh.history.push_back(failedFace(was.report.reason));
  retrial.replaced[face] = std::move(was);
  return 0;
}

}  // namespace

bool mayRefuseReflex(const Retrial& retrial, const FaceMeshes& state, std::size_t face) {
  return retrial.options.mayMakeReflex && failed(state.meshes[face]);
}

std::optional<std::size_t> meshWithoutReflex(Retrial& retrial, FaceMeshes& state,
                                             std::size_t face) {
  return meshAgain(retrial, state, face, {.refusesReflex = true});
}

bool mayIgnoreNormals(const Retrial& retrial, const FaceMeshes& state, std::size_t face) {
  return retrial.options.mayTilt && failed(state.meshes[face]);
}

std::optional<std::size_t> meshIgnoringNormals(Retrial& retrial, FaceMeshes& state,
                                               std::size_t face) {
  return meshAgain(retrial, state, face, {.ignoresNormals = true});
}

void restoreFailedFace(Retrial& retrial, FaceMeshes& state, const FaceMeshes&, std::size_t face) {
  state.meshes[face] = std::move(retrial.replaced.at(face));
}

}  // namespace af2::geometry
