#include "geometry/quality/meeting_fronts.h"

#include <algorithm>

namespace af2::geometry {
namespace {

/// Vertices inside faces from which no edge leads farther away from all boundaries.
std::vector<bool> farthestVertices(const VertexNeighbors& neighbors,
                                   const std::vector<std::uint32_t>& distance) {
  std::vector<bool> isFarthest(distance.size(), false);
  for (std::size_t v = 0; v < distance.size(); ++v)
    isFarthest[v] = distance[v] > 0 && distance[v] != kNoBoundary &&
                    std::ranges::none_of(neighbors.of(v), [&](std::uint32_t neighbor) {
                      return distance[neighbor] > distance[v];
                    });
  return isFarthest;
}

}  // namespace

MeetingFronts measureMeetingFronts(const ModelMesh& mesh, const VertexNeighbors& neighbors,
                                   const std::vector<std::uint32_t>& distance,
                                   const std::vector<VertexState>& states,
                                   const std::vector<double>& jacobians) {
  const std::vector<bool> isFarthest = farthestVertices(neighbors, distance);
  MeetingFronts result;
  std::vector<double> there, elsewhere;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const bool isThere = std::ranges::any_of(mesh.elements[e].vertices(),
                                             [&](VertexId v) { return isFarthest[v.value]; });
    (isThere ? there : elsewhere).push_back(jacobians[e]);
  }
  for (std::size_t v = 0; v < states.size(); ++v) {
    if (states[v] == VertexState::Unused || distance[v] == 0) continue;
    VertexCount& count = isFarthest[v] ? result.irregular : result.irregularElsewhere;
    ++count.all;
    count.irregular += states[v] == VertexState::Irregular;
  }
  result.jacobian = distributionOf(std::move(there));
  result.jacobianElsewhere = distributionOf(std::move(elsewhere));
  return result;
}

}  // namespace af2::geometry
