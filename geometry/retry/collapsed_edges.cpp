#include "geometry/retry/collapsed_edges.h"

#include <algorithm>

#include "geometry/retry/retry_limits.h"

namespace af2::geometry {

void findShortEdges(Retrial& retrial, const FaceMeshes& state, std::size_t face) {
  const FaceDiagnosis& diagnosis = state.meshes[face].diagnosis;
  if (!failed(state.meshes[face]) || !diagnosis.isBad) return;  // without a boundary all is lost
  std::vector<CollapsedEdges>& choices = retrial.faces[face].shortEdges;
  choices = retrial.model.shortEdges(face, state.divided, diagnosis.places);
  std::ranges::reverse(choices);
}

bool mayCollapseEdges(const Retrial& retrial, const FaceMeshes& state, std::size_t face) {
  const FaceRecord& record = retrial.faces[face];
  if (!failed(state.meshes[face]) || record.shortEdges.empty()) return false;
  return record.failures >= kFailuresBeforeCollapse || record.hasFault || !retrial.hasBudgetLeft ||
         state.meshes[face].diagnosis.places.empty();
}

std::optional<std::size_t> collapseEdges(Retrial& retrial, FaceMeshes&, std::size_t face) {
  std::vector<CollapsedEdges>& choices = retrial.faces[face].shortEdges;
  const std::size_t count = choices.back().size();
  retrial.requests.dropAll(face);
  retrial.requests.collapse(face, choices.back());
  choices.pop_back();
  return count;
}

void uncollapseEdges(Retrial& retrial, FaceMeshes&, const FaceMeshes&, std::size_t face) {
  retrial.requests.dropAll(face);
}

}  // namespace af2::geometry
