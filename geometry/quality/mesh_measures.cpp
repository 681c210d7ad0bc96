#include "geometry/quality/mesh_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "geometry/mesh/mesh_sides.h"
#include "geometry/mesh/quality.h"
#include "geometry/quality/boundary_distance.h"
#include "geometry/quality/element_measures.h"
#include "geometry/quality/irregular_vertices.h"
#include "geometry/quality/meeting_fronts.h"
#include "geometry/quality/mesh_fans.h"

namespace af2::geometry {
namespace {

/// 1 or -1 for a mesh in a plane of constant z that is seen from above or from below; 0 for others.
double orientationOf(const ModelMesh& mesh) {
  double area = 0, low = 0, high = 0, extent = 0;
  bool isFirst = true;
  for (const Element& element : mesh.elements) {
    std::array<Point3, 4> points;
    const auto corners = element.vertices();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point3& p = points[i] = mesh.vertices[corners[i].value];
      low = isFirst ? p.z : std::min(low, p.z);
      high = isFirst ? p.z : std::max(high, p.z);
      extent = std::max({extent, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      isFirst = false;
    }
    area += areaVector({points.data(), corners.size()}).z;
  }
  if (high - low > 1e-9 * extent) return 0;
  return area < 0 ? -1 : 1;
}

struct ElementValues {
  std::vector<double> jacobians, angles;
};

/// Returns the scaled Jacobians by element.
std::vector<double> measureElements(const ModelMesh& mesh, MeshMeasures& result) {
  const double orientation = orientationOf(mesh);
  ElementValues triangles, quads;
  std::vector<double> jacobians, qualities, aspects;
  for (const Element& element : mesh.elements) {
    std::array<Point3, 4> points;
    const auto corners = element.vertices();
    for (std::size_t i = 0; i < corners.size(); ++i) points[i] = mesh.vertices[corners[i].value];
    const CornerPoints at(points.data(), corners.size());
    const bool isTurned = orientation * areaVector(at).z < 0;
    ElementValues& values = element.isQuad() ? quads : triangles;
    jacobians.push_back((isTurned ? -1 : 1) * scaledJacobian(at));
    values.jacobians.push_back(jacobians.back());
    for (std::size_t i = 0; i < corners.size(); ++i) values.angles.push_back(cornerAngle(at, i));
    result.inverted += jacobians.back() <= 0;
    qualities.push_back(shapeQuality(mesh.vertices, element));
    aspects.push_back(aspectRatio(at));
  }
  result.triangles = triangles.jacobians.size();
  result.quads = quads.jacobians.size();
  result.jacobian = distributionOf(jacobians);
  result.triangleJacobian = distributionOf(std::move(triangles.jacobians));
  result.quadJacobian = distributionOf(std::move(quads.jacobians));
  result.triangleAngles = distributionOf(std::move(triangles.angles));
  result.quadAngles = distributionOf(std::move(quads.angles));
  result.quality = distributionOf(std::move(qualities));
  result.aspect = distributionOf(std::move(aspects));
  return jacobians;
}

void measureLengths(const ModelMesh& mesh, double size, MeshMeasures& result) {
  std::vector<double> lengths, ratios;
  MeshSides(mesh).forEachEdge([&](VertexId from, std::span<const MeshSide> sides) {
    const std::uint32_t to = sides.front().to;
    lengths.push_back(distance(mesh.vertices[from.value], mesh.vertices[to]));
    if (size == 0 && !mesh.wantedSizes.empty())
      ratios.push_back(2 * lengths.back() / (mesh.wantedSizes[from.value] + mesh.wantedSizes[to]));
  });
  result.medianLength = distributionOf(lengths).median;
  result.lengthUnit = size > 0          ? LengthReference::GivenSize
                      : !ratios.empty() ? LengthReference::WantedSizes
                                        : LengthReference::MedianLength;
  if (ratios.empty()) {
    const double unit = size > 0 ? size : result.medianLength;
    for (const double length : lengths) ratios.push_back(unit > 0 ? length / unit : 0);
  }
  result.lengths = distributionOf(std::move(ratios));
}

void measureVertices(const ModelMesh& mesh, const MeshFans& fans,
                     const std::vector<double>& jacobians, MeshMeasures& result) {
  const VertexNeighbors neighbors(mesh);
  const std::vector<std::uint32_t> distance = edgesToBoundary(neighbors, fans);
  const std::vector<VertexState> states = vertexStates(mesh, fans);
  result.irregular = countIrregularVertices(mesh, fans, states, distance);
  result.meeting = measureMeetingFronts(mesh, neighbors, distance, states, jacobians);
}

void measureShape(const ModelMesh& mesh, const MeshFans& fans, MeshMeasures& result) {
  const EdgeCounts& edges = fans.edges();
  result.vertices = result.irregular.inner.all + result.irregular.boundary.all;
  result.shape = {edges.all,
                  edges.free,
                  edges.nonManifold,
                  edges.turned,
                  edges.folded,
                  fans.components(),
                  std::set(mesh.face.begin(), mesh.face.end()).size(),
                  fans.regions(),
                  static_cast<long>(result.vertices) - static_cast<long>(edges.all) +
                      static_cast<long>(mesh.elements.size())};
}

}  // namespace

MeshMeasures measureMesh(const ModelMesh& mesh, const MeasureOptions& options) {
  MeshMeasures result;
  if (mesh.elements.empty()) return result;
  const std::vector<double> jacobians = measureElements(mesh, result);
  measureLengths(mesh, options.size, result);
  const MeshFans fans(mesh, options.featureDegrees);
  measureVertices(mesh, fans, jacobians, result);
  result.spokes = distributionOf(spokeDeviations(mesh, fans));
  measureShape(mesh, fans, result);
  return result;
}

std::vector<std::pair<VertexId, VertexId>> boundaryEdges(const ModelMesh& mesh,
                                                         const MeasureOptions& options) {
  return MeshFans(mesh, options.featureDegrees).boundaryEdges();
}

}  // namespace af2::geometry
