#include "geometry/mesh/face_mesh.h"

#include <algorithm>
#include <utility>

namespace af2::geometry {

namespace {

/// By vertex of a face: the larger of the wanted size and the lengths of the segments that end
/// there.
std::vector<double> usualLengths(const FaceMesh& mesh, const DividedEdges& divided) {
  std::vector<double> lengths = mesh.wantedSizes;
  std::map<std::uint32_t, double> longest;  // by point
  for (const SegmentUse& use : mesh.uses) {
    const std::vector<std::uint32_t>& points =
        divided.edges[static_cast<std::size_t>(use.edge) - 1].points;
    const std::uint32_t from = points[use.segment], to = points[use.segment + 1];
    const double length = distance(divided.points[from], divided.points[to]);
    for (const std::uint32_t point : {from, to}) longest[point] = std::max(longest[point], length);
  }
  for (std::size_t v = 0; v < mesh.boundary.size(); ++v)
    lengths[v] = std::max(lengths[v], longest[mesh.boundary[v]]);
  return lengths;
}

}  // namespace

bool reachesTooFar(const FaceMesh& mesh, const DividedEdges& divided) {
  constexpr double kMax = 5, kShare = 0.05;
  const std::vector<double> usual = usualLengths(mesh, divided);
  const auto at = [&](VertexId v) -> const Point3& {
    const std::size_t given = mesh.boundary.size();
    return v.value < given ? divided.points[mesh.boundary[v.value]] : mesh.inside[v.value - given];
  };
  const auto isFar = [&](const Element& element) {
    VertexId last = element.vertices().back();
    for (const VertexId v : element.vertices()) {
      if (distance(at(last), at(v)) > kMax * std::max(usual[last.value], usual[v.value]))
        return true;
      last = v;
    }
    return false;
  };
  const auto count = std::ranges::count_if(mesh.elements, isFar);
  return static_cast<double>(count) > kShare * static_cast<double>(mesh.elements.size());
}

void loadBulk(FaceMesh& mesh) {
  if (!mesh.bulk) return;
  FaceBulk bulk = mesh.bulk->load();
  mesh.inside = std::move(bulk.inside);
  mesh.elements = std::move(bulk.elements);
  mesh.origins = std::move(bulk.origins);
  mesh.wantedSizes.insert(mesh.wantedSizes.end(), bulk.wantedSizes.begin(), bulk.wantedSizes.end());
  mesh.bulk.reset();
  mesh.evidence.reset();
}

MiddlesByFace takeMiddles(std::vector<FaceMesh>& meshes) {
  MiddlesByFace middles;
  for (FaceMesh& mesh : meshes) middles[mesh.report.id] = std::move(mesh.middles);
  return middles;
}

/// The elements of a face are consecutive.
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
