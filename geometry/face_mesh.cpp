#include "geometry/face_mesh.h"

namespace af2::geometry {

MiddlesByFace takeMiddles(std::vector<FaceMesh>& meshes) {
  MiddlesByFace middles;
  for (FaceMesh& mesh : meshes) middles[mesh.report.id] = std::move(mesh.middles);
  return middles;
}

/// The elements of a face lie one after the other.
std::vector<SideMiddles> middlesOf(const ModelMesh& mesh, const MiddlesByFace& byFace) {
  std::vector<SideMiddles> middles;
  for (std::size_t first = 0; first < mesh.face.size();) {
    const std::vector<SideMiddles>& own = byFace.at(mesh.face[first]);
    middles.insert(middles.end(), own.begin(), own.end());
    first += own.size();
  }
  return middles;
}

double shareOfOptimizing(const std::vector<FaceMesh>& meshes) {
  double all = 0, optimizing = 0;
  for (const FaceMesh& mesh : meshes) {
    all += mesh.report.seconds;
    optimizing += mesh.optimizeSeconds;
  }
  return all > 0 ? optimizing / all : 0;
}

}  // namespace af2::geometry
