#include "geometry/mesh/second_order.h"

#include <algorithm>
#include <map>
#include <set>

#include "engine/base/error.h"

namespace af2::geometry {
namespace {

class Builder {
 public:
  Builder(ModelMesh& mesh, const std::vector<SideMiddles>& middles,
          const std::vector<std::pair<SideEnds, SideEnds>>& alike)
      : mesh_(mesh), middles_(middles) {
    for (const auto& [one, other] : alike) {
      alike_[one].push_back(other);
      alike_[other].push_back(one);
    }
  }

  void build() {
    for (const EdgeSegment& s : mesh_.segments) onEdges_[std::minmax(s.from, s.to)] = s.middle;
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) addSides(e);
    straighten();
  }

 private:
  void addSides(std::size_t e) {
    const std::vector<SideEnds> sides = sidesOf(mesh_.elements[e]);
    std::array<VertexId, 4> ids;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const auto [found, isNew] = ids_.try_emplace(sides[i], VertexId(mesh_.vertices.size()));
      ids[i] = found->second;
      if (!isNew) continue;
      const auto onEdge = onEdges_.find(sides[i]);
      addVertex(sides[i], onEdge == onEdges_.end() ? middles_[e][i] : onEdge->second);
    }
    mesh_.midsides.push_back(ids);
  }

  void addVertex(const SideEnds& side, const Point3& place) {
    mesh_.vertices.push_back(place);
    if (mesh_.wantedSizes.empty()) return;
    mesh_.wantedSizes.push_back(
        (mesh_.wantedSizes[side.first.value] + mesh_.wantedSizes[side.second.value]) / 2);
  }

  /// A side that becomes straight may spoil the element beyond it, which then becomes straight,
  /// too.
  void straighten() {
    std::vector<bool> isStraight(mesh_.elements.size(), false);
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
        if (isStraight[e] || scaledJacobian(mesh_, e) > 0) continue;
        isStraight[e] = changed = true;
        for (const SideEnds& side : sidesOf(mesh_.elements[e])) straighten(side);
      }
    }
    for (std::size_t e = 0; e < isStraight.size(); ++e)
      if (isStraight[e]) mesh_.straightened.push_back(ElementId(e));
  }

  void straighten(const SideEnds& side) {
    if (!straight_.insert(side).second) return;
    mesh_.vertices[ids_.at(side).value] =
        0.5 * (mesh_.vertices[side.first.value] + mesh_.vertices[side.second.value]);
    if (const auto others = alike_.find(side); others != alike_.end())
      for (const SideEnds& other : others->second) straighten(other);
  }

  ModelMesh& mesh_;
  const std::vector<SideMiddles>& middles_;
  std::map<SideEnds, Point3> onEdges_;
  std::map<SideEnds, VertexId> ids_;
  std::map<SideEnds, std::vector<SideEnds>> alike_;
  std::set<SideEnds> straight_;
};

/// Corners, then middles of sides.
std::vector<Point3> nodesOf(const ModelMesh& mesh, std::size_t e) {
  std::vector<Point3> nodes;
  const std::size_t size = mesh.elements[e].vertices().size();
  for (const VertexId v : mesh.elements[e].vertices()) nodes.push_back(mesh.vertices[v.value]);
  for (std::size_t i = 0; i < size; ++i) nodes.push_back(mesh.vertices[mesh.midsides[e][i].value]);
  return nodes;
}

/// Along the normal of the straight triangle, the Jacobian is a polynomial of degree two; its
/// coefficients in the basis of Bernstein bound it from below.
double triangleJacobian(const std::vector<Point3>& p) {
  const Point3 normal = cross(p[1] - p[0], p[2] - p[0]);
  const double straight = dot(normal, normal);
  if (straight == 0) return 0;
  const auto jacobianAt = [&](double x, double y) {
    const double z = 1 - x - y;
    const Point3 dx = (1 - 4 * z) * p[0] + (4 * x - 1) * p[1] + (4 * (z - x)) * p[3] +
                      (4 * y) * p[4] + (-4 * y) * p[5];
    const Point3 dy = (1 - 4 * z) * p[0] + (4 * y - 1) * p[2] + (-4 * x) * p[3] + (4 * x) * p[4] +
                      (4 * (z - y)) * p[5];
    return dot(cross(dx, dy), normal) / straight;
  };
  const std::array corner{jacobianAt(0, 0), jacobianAt(1, 0), jacobianAt(0, 1)};
  const std::array middle{jacobianAt(0.5, 0), jacobianAt(0.5, 0.5), jacobianAt(0, 0.5)};
  double least = std::ranges::min(corner);
  for (std::size_t i = 0; i < 3; ++i)
    least = std::min(least, 2 * middle[i] - (corner[i] + corner[(i + 1) % 3]) / 2);
  return least;
}

double quadJacobian(const std::vector<Point3>& p) {
  constexpr std::array<Point2, 4> kCorner{Point2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const Point3 normal = cross(p[2] - p[0], p[3] - p[1]);
  const double straight = dot(normal, normal) / 8;
  if (straight == 0) return 0;
  const auto jacobianAt = [&](Point2 at) {
    Point3 dx, dy;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto [a, b] = std::pair(kCorner[i].x, kCorner[i].y);
      dx = dx + (a * (1 + b * at.y) * (2 * a * at.x + b * at.y) / 4) * p[i];
      dy = dy + (b * (1 + a * at.x) * (2 * b * at.y + a * at.x) / 4) * p[i];
      const Point2 side = 0.5 * (kCorner[i] + kCorner[(i + 1) % 4]);
      if (side.x == 0) {
        dx = dx + (-at.x * (1 + side.y * at.y)) * p[4 + i];
        dy = dy + (side.y * (1 - at.x * at.x) / 2) * p[4 + i];
      } else {
        dx = dx + (side.x * (1 - at.y * at.y) / 2) * p[4 + i];
        dy = dy + (-at.y * (1 + side.x * at.x)) * p[4 + i];
      }
    }
    return dot(cross(dx, dy), normal) / straight;
  };
  double least = jacobianAt({0, 0});
  for (std::size_t i = 0; i < 4; ++i) {
    least = std::min(least, jacobianAt(kCorner[i]));
    least = std::min(least, jacobianAt(0.5 * (kCorner[i] + kCorner[(i + 1) % 4])));
  }
  return least;
}

}  // namespace

std::vector<SideEnds> sidesOf(const Element& element) {
  const auto corners = element.vertices();
  std::vector<SideEnds> sides;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sides.push_back(std::minmax(corners[i], corners[(i + 1) % corners.size()]));
  return sides;
}

void makeSecondOrder(ModelMesh& mesh, const std::vector<SideMiddles>& middles,
                     const std::vector<std::pair<SideEnds, SideEnds>>& alike) {
  AF2_CHECK(middles.size() == mesh.elements.size(), "each element has its middles of sides");
  Builder(mesh, middles, alike).build();
}

std::vector<SideMiddles> takeSecondOrder(ModelMesh& mesh) {
  std::vector<SideMiddles> middles(mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (std::size_t i = 0; i < mesh.elements[e].vertices().size(); ++i)
      middles[e][i] = mesh.vertices[mesh.midsides[e][i].value];
  mesh.vertices.resize(cornerVertices(mesh).size());
  if (!mesh.wantedSizes.empty()) mesh.wantedSizes.resize(mesh.vertices.size());
  mesh.midsides.clear();
  mesh.straightened.clear();
  return middles;
}

double scaledJacobian(const ModelMesh& mesh, std::size_t element) {
  const std::vector<Point3> nodes = nodesOf(mesh, element);
  return mesh.elements[element].isQuad() ? quadJacobian(nodes) : triangleJacobian(nodes);
}

}  // namespace af2::geometry
