#include "geometry/domain/domain_boundary.h"

#include <algorithm>

namespace af2::geometry {
namespace {

class BoundaryMaker {
 public:
  BoundaryMaker(const DomainFace& face, const DividedEdges& divided)
      : face_(face), divided_(divided) {}

  FaceBoundary make() {
    collectPoints();
    for (const auto& loop : face_.loops) {
      std::vector<BoundaryCorner>& corners = boundary_.input.loops.emplace_back();
      for (const CurveUse& use : loop) addUse(use, corners);
    }
    for (const std::size_t corner : face_.isolated)
      boundary_.input.isolated.push_back(cornerAt(static_cast<std::uint32_t>(corner)));
    boundary_.input.vertexCount = boundary_.points.size();
    boundary_.closedInParameters = face_.surface->inParameters() != nullptr;
    boundary_.canBeCut = face_.canBeCut;
    boundary_.repairs = face_.notes;
    return std::move(boundary_);
  }

 private:
  void collectPoints() {
    std::vector<std::uint32_t>& points = boundary_.points;
    for (const auto& loop : face_.loops)
      for (const CurveUse& use : loop) {
        const DividedEdge& edge = divided_.edges[use.curve];
        points.insert(points.end(), edge.points.begin(), edge.points.end());
      }
    for (const std::size_t corner : face_.isolated)
      points.push_back(static_cast<std::uint32_t>(corner));
    std::ranges::sort(points);
    points.erase(std::ranges::unique(points).begin(), points.end());
  }

  void addUse(const CurveUse& use, std::vector<BoundaryCorner>& corners) {
    const std::vector<std::uint32_t>& points = divided_.edges[use.curve].points;
    const auto segments = static_cast<std::uint32_t>(points.size() - 1);
    for (std::uint32_t i = 0; i < segments; ++i) {
      const std::uint32_t segment = use.reversed ? segments - 1 - i : i;
      corners.push_back(cornerAt(points[use.reversed ? segment + 1 : segment]));
      boundary_.uses.push_back({static_cast<int>(use.curve) + 1, segment});
    }
  }

  BoundaryCorner cornerAt(std::uint32_t point) const {
    const auto local = std::ranges::lower_bound(boundary_.points, point);
    const Point3& position = divided_.points[point];
    SurfacePoint onSurface = face_.nearest(position);
    onSurface.position = position;
    return {VertexId(static_cast<std::size_t>(local - boundary_.points.begin())), onSurface};
  }

  const DomainFace& face_;
  const DividedEdges& divided_;
  FaceBoundary boundary_;
};

}  // namespace

FaceBoundary boundaryOf(const DomainFace& face, const DividedEdges& divided) {
  return BoundaryMaker(face, divided).make();
}

}  // namespace af2::geometry
