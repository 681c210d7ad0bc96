#include "geometry/retry/score.h"

#include <algorithm>

namespace af2::geometry {

Score scoreOf(const FaceMeshes& state) {
  Score score;
  for (const FaceMesh& mesh : state.meshes) {
    if (failed(mesh))
      ++score.failedFaces;
    else
      score.poorness += mesh.diagnosis.poorness;
    if (mesh.diagnosis.hasBadAngle) ++score.badAngles;
    score.elements += elementCount(mesh);
  }
  score.failedFaces += facesThatCross(state.faults.crossings, {}).size();
  return score;
}

std::ptrdiff_t crossingsAt(const FaceMeshes& state, std::size_t face) {
  const int id = state.meshes[face].report.id;
  return std::ranges::count_if(state.faults.crossings, [&](const Crossing& crossing) {
    return std::ranges::count(crossing.faces, id) > 0;
  });
}

}  // namespace af2::geometry
