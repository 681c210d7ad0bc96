#include "geometry/quality/irregular_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/quality/element_measures.h"

namespace af2::geometry {
namespace {

constexpr double kQuadDegrees = 90, kTriangleDegrees = 60;
/// Boundaries that turn by more than this at a vertex have a corner there.
constexpr double kSmoothDegrees = 30;

double idealAngle(const Element& element) {
  return element.isQuad() ? kQuadDegrees : kTriangleDegrees;
}

double angleAt(const ModelMesh& mesh, std::uint32_t corner) {
  std::array<Point3, 4> points;
  const auto corners = mesh.elements[corner / 4].vertices();
  for (std::size_t i = 0; i < corners.size(); ++i) points[i] = mesh.vertices[corners[i].value];
  return cornerAngle({points.data(), corners.size()}, corner % 4);
}

double angleOf(const ModelMesh& mesh, const Fan& fan) {
  double angle = 0;
  for (const std::uint32_t corner : fan.corners) angle += angleAt(mesh, corner);
  return angle;
}

bool isRegular(const ModelMesh& mesh, const Fan& fan) {
  double sum = 0, least = kQuadDegrees;
  for (const std::uint32_t corner : fan.corners) {
    const double ideal = idealAngle(mesh.elements[corner / 4]);
    sum += ideal;
    least = std::min(least, ideal);
  }
  const double missing = (fan.isClosed ? 360 : angleOf(mesh, fan)) - sum;
  const bool isSingle = !fan.isClosed && fan.corners.size() == 1;
  return (isSingle && missing < 0) || std::abs(missing) <= least / 2;
}

/// What Euler's formula says of the elements of one region.
struct Region {
  std::size_t elements = 0, quads = 0, fans = 0;
  double edges = 0;          ///< those on its boundary count once for each side in the region
  double boundaryTurns = 0;  ///< 180 degrees minus the regular angle, summed over its boundary

  /// The angle of the kind of element of which it has more.
  double unit() const { return 2 * quads >= elements ? kQuadDegrees : kTriangleDegrees; }
  /// In units: how much the vertices inside lack in sum, if the boundary is regular.
  double lack() const {
    const double euler = static_cast<double>(fans) - edges + static_cast<double>(elements);
    return (360 * euler - boundaryTurns) / unit();
  }
};

std::vector<Region> regionsOf(const ModelMesh& mesh, const MeshFans& fans) {
  std::vector<Region> regions(fans.regions());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    Region& region = regions[fans.regionOf(e)];
    ++region.elements;
    region.quads += mesh.elements[e].isQuad();
    region.edges += mesh.elements[e].size() / 2.0;
  }
  for (const Fan& fan : fans.fans()) {
    Region& region = regions[fan.region];
    ++region.fans;
    if (fan.isClosed) continue;
    region.edges += 0.5;  // a region has as many boundary sides as fans that are not closed
    const double unit = region.unit();
    region.boundaryTurns += 180 - unit * std::max(1.0, std::round(angleOf(mesh, fan) / unit));
  }
  return regions;
}

}  // namespace

std::vector<VertexState> vertexStates(const ModelMesh& mesh, const MeshFans& fans) {
  std::vector<VertexState> states(mesh.vertices.size(), VertexState::Unused);
  for (const Fan& fan : fans.fans()) {
    VertexState& state = states[fan.vertex.value];
    if (state != VertexState::Irregular)
      state = isRegular(mesh, fan) ? VertexState::Regular : VertexState::Irregular;
  }
  return states;
}

IrregularVertices countIrregularVertices(const ModelMesh& mesh, const MeshFans& fans,
                                         const std::vector<VertexState>& states,
                                         const std::vector<std::uint32_t>& distance) {
  constexpr std::size_t kLast = IrregularVertices::kRings - 1;
  IrregularVertices result;
  for (std::size_t v = 0; v < states.size(); ++v) {
    if (states[v] == VertexState::Unused) continue;
    for (VertexCount* const count : {&result.rings[std::min<std::size_t>(distance[v], kLast)],
                                     distance[v] == 0 ? &result.boundary : &result.inner}) {
      ++count->all;
      count->irregular += states[v] == VertexState::Irregular;
    }
  }
  double least = 0;
  for (const Region& region : regionsOf(mesh, fans)) least += std::abs(region.lack());
  result.least = static_cast<std::size_t>(std::llround(least));
  return result;
}

std::vector<double> spokeDeviations(const ModelMesh& mesh, const MeshFans& fans) {
  const std::vector<Region> regions = regionsOf(mesh, fans);
  std::vector<double> deviations;
  for (const Fan& fan : fans.fans()) {
    const double angle = angleOf(mesh, fan);
    if (fan.isClosed || std::abs(angle - 180) > kSmoothDegrees) continue;
    const double parts = 180 / regions[fan.region].unit();  // 2 or 3
    double direction = 0;
    for (std::size_t i = 0; i + 1 < fan.corners.size(); ++i) {
      direction += angleAt(mesh, fan.corners[i]);
      const double nearest = std::clamp(std::round(direction / angle * parts), 1.0, parts - 1);
      deviations.push_back(std::abs(direction - nearest * angle / parts));
    }
  }
  return deviations;
}

}  // namespace af2::geometry
