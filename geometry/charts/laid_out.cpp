#include "geometry/charts/laid_out.h"

#include <algorithm>

#include "engine/mesh/element_shape.h"
#include "engine/mesh/mesh_check.h"

namespace af2::geometry {

namespace {

class LayingOut {
 public:
  LayingOut(const FrontInput& input, const PlaneMap& map)
      : input_(input), map_(map), places_(input.vertexCount) {}

  LaidOutFront layOut() {
    for (const auto& loop : input_.loops) addLoop(loop);
    for (const BoundaryCorner& corner : input_.isolated)
      result_.input.isolated.push_back(cornerAt(corner.vertex, map_.flatten(corner.point), 0));
    result_.input.vertexCount = result_.original.size();
    return std::move(result_);
  }

 private:
  struct Place {
    VertexId id;
    Point2 at;
  };

  void addLoop(const std::vector<BoundaryCorner>& loop) {
    std::vector<Point2> at;
    for (const BoundaryCorner& corner : loop) at.push_back(map_.flatten(corner.point));
    std::vector<BoundaryCorner>& flat = result_.input.loops.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const double ahead = distance(at[i], at[(i + 1) % at.size()]);
      const double behind = distance(at[i], at[(i + at.size() - 1) % at.size()]);
      flat.push_back(cornerAt(loop[i].vertex, at[i], kSamePlace * std::min(ahead, behind)));
    }
  }

  /// Curves in the parameters end only about at the same place.
  BoundaryCorner cornerAt(VertexId vertex, Point2 at, double tolerance) {
    std::vector<Place>& places = places_[vertex.value];
    for (const Place& place : places)
      if (distance(place.at, at) <= tolerance) return {place.id, pointInPlane(place.at)};
    result_.hasTwins = result_.hasTwins || !places.empty();
    places.push_back({VertexId(result_.original.size()), at});
    result_.original.push_back(vertex);
    return {places.back().id, pointInPlane(at)};
  }

  /// A share of the shorter segment at a corner.
  static constexpr double kSamePlace = 0.1;

  const FrontInput& input_;
  const PlaneMap& map_;
  std::vector<std::vector<Place>> places_;  ///< by vertex of the face
  LaidOutFront result_;
};

bool hasFold(const Mesh& mesh) {
  return std::ranges::any_of(mesh.elements, [&](const Element& e) { return leans(mesh, e); });
}

}  // namespace

LaidOutFront layOut(const FrontInput& input, const PlaneMap& map) {
  return LayingOut(input, map).layOut();
}

void lift(MeshingResult& result, const LaidOutFront& front, const FrontInput& original,
          const PlaneMap& map) {
  const std::size_t given = front.original.size();
  const auto idOf = [&](VertexId v) {
    return v.value < given ? front.original[v.value]
                           : VertexId(original.vertexCount + v.value - given);
  };
  std::vector<SurfacePoint> vertices(original.vertexCount);
  for (const auto& loop : original.loops)
    for (const BoundaryCorner& corner : loop) vertices[corner.vertex.value] = corner.point;
  for (const BoundaryCorner& corner : original.isolated)
    vertices[corner.vertex.value] = corner.point;
  const std::vector<SurfacePoint>& flat = result.mesh.vertices;
  if (flat.size() > given) vertices.reserve(original.vertexCount + flat.size() - given);
  for (std::size_t v = given; v < flat.size(); ++v) vertices.push_back(map.lift(placeOf(flat[v])));
  result.mesh.vertices = std::move(vertices);
  for (Element& element : result.mesh.elements)
    for (VertexId& v : element.corners)
      if (!v.isNone()) v = idOf(v);
  for (StuckEdge& edge : result.stuck) {
    edge.from = idOf(edge.from);
    edge.to = idOf(edge.to);
    for (RuleRefusal& refusal : edge.refusals) {
      if (!refusal.from.isNone()) refusal.from = idOf(refusal.from);
      if (!refusal.to.isNone()) refusal.to = idOf(refusal.to);
    }
  }
  for (VertexId& v : result.unused) v = idOf(v);
}

std::string faultOfLifted(const Mesh& mesh, const LaidOutFront& front, const FrontInput& original,
                          bool ignoresNormals) {
  // Where the two sides of a seam come together, edges may meet that were apart.
  if (front.hasTwins)
    if (std::string fault = faultOf(mesh, boundaryOf(original)); !fault.empty()) return fault;
  return !ignoresNormals && hasFold(mesh) ? "an element tilts too far against the surface" : "";
}

}  // namespace af2::geometry
