#include "geometry/retry/ignoring_normals.h"

#include <algorithm>
#include <utility>

#include "geometry/retry/retry_limits.h"

namespace af2::geometry {

namespace {

/// Each of the faces that are left may take its part, or a little in any case.
TryLimits tryWithin(double left, double faces) {
  TryLimits limits;
  limits.maxCandidates =
      static_cast<std::size_t>(std::min(left, std::max(kMinBudgetIgnoringNormals, left / faces)));
  limits.failedBefore = true;
  limits.ignoresNormals = true;
  return limits;
}

bool isOfUse(const FaceMesh& mesh, const DividedEdges& divided) {
  return !failed(mesh) && !mesh.elements.empty() && !reachesTooFar(mesh, divided);
}

}  // namespace

bool mayIgnoreNormals(const Retrial&, const FaceMeshes& state, std::size_t face) {
  return failed(state.meshes[face]);
}

std::optional<std::size_t> meshIgnoringNormals(Retrial& retrial, FaceMeshes& state,
                                               std::size_t face) {
  const double left = retrial.budget.left();
  if (left <= 0) {
    retrial.hasBudgetLeft = false;
    return std::nullopt;
  }
  const auto first = state.meshes.begin() + static_cast<std::ptrdiff_t>(face);
  const auto faces = static_cast<double>(std::count_if(first, state.meshes.end(), failed));
  FaceMesh was = std::move(state.meshes[face]);
  retrial.model.mesh(face, retrial.options.sizes, tryWithin(left, faces), state);
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

void restoreFailedFace(Retrial& retrial, FaceMeshes& state, const FaceMeshes&, std::size_t face) {
  state.meshes[face] = std::move(retrial.replaced.at(face));
}

}  // namespace af2::geometry
