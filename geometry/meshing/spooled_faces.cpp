#include "geometry/meshing/spooled_faces.h"

#include <algorithm>
#include <span>
#include <utility>

namespace af2::geometry {

namespace {

/// The boundary of a face by its points. Where several vertices are at one point, as along a seam,
/// the first one stands for all.
class BoundaryPoints {
 public:
  explicit BoundaryPoints(const std::vector<std::uint32_t>& boundary) : boundary_(boundary) {
    for (std::uint32_t v = 0; v < boundary.size(); ++v) vertices_.emplace_back(boundary[v], v);
    std::ranges::sort(vertices_);
  }

  VertexId ofVertex(VertexId v) const {
    return v.value < boundary_.size() ? ofPoint(boundary_[v.value]) : v;
  }
  VertexId ofPoint(std::uint32_t point) const {
    const auto first = std::ranges::lower_bound(vertices_, std::pair(point, 0u));
    return first != vertices_.end() && first->first == point ? VertexId(first->second) : VertexId();
  }

 private:
  const std::vector<std::uint32_t>& boundary_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> vertices_;  ///< point and vertex
};

/// The face as a mesh of its own. Takes its elements and the vertices inside.
ModelMesh takenAlone(FaceMesh& mesh, const DividedEdges& divided) {
  const BoundaryPoints points(mesh.boundary);
  ModelMesh alone;
  alone.vertices.reserve(mesh.boundary.size() + mesh.inside.size());
  for (const std::uint32_t point : mesh.boundary) alone.vertices.push_back(divided.points[point]);
  alone.vertices.insert(alone.vertices.end(), mesh.inside.begin(), mesh.inside.end());
  std::vector<Point3>().swap(mesh.inside);
  alone.elements = std::exchange(mesh.elements, {});
  for (Element& element : alone.elements)
    for (VertexId& corner : element.corners)
      if (!corner.isNone()) corner = points.ofVertex(corner);
  alone.face.assign(alone.elements.size(), mesh.report.id);
  for (const SegmentUse& use : mesh.uses) {
    const auto& along = divided.edges[static_cast<std::size_t>(use.edge) - 1].points;
    const VertexId from = points.ofPoint(along[use.segment]);
    const VertexId to = points.ofPoint(along[use.segment + 1]);
    if (!from.isNone() && !to.isNone()) alone.segments.push_back({from, to, use.edge, 1, {}});
  }
  return alone;
}

}  // namespace

void spoolFace(FaceMesh& mesh, const DividedEdges& divided, bool mayCross,
               const std::shared_ptr<SpoolFile>& file) {
  if (mesh.bulk || (mesh.elements.empty() && mesh.inside.empty())) return;
  const std::size_t boundary = mesh.boundary.size();
  const ModelMesh alone = takenAlone(mesh, divided);
  mesh.evidence = std::make_shared<const FaceEvidence>(evidenceOf(alone, boundary, mayCross));
  const std::span<const double> sizes(mesh.wantedSizes);
  mesh.bulk = std::make_shared<const SpooledFace>(
      file,
      SpooledFace::Content{std::span(alone.vertices).subspan(boundary),
                           sizes.empty() ? sizes : sizes.subspan(boundary), alone.elements,
                           mesh.origins},
      boundary);
  mesh.wantedSizes.resize(std::min(mesh.wantedSizes.size(), boundary));
  mesh.wantedSizes.shrink_to_fit();
  std::vector<ElementOrigin>().swap(mesh.origins);
}

EvidenceOfParts evidenceOf(const std::vector<FaceMesh>& meshes) {
  EvidenceOfParts evidence;
  for (const FaceMesh& mesh : meshes)
    if (mesh.bulk) evidence.push_back(mesh.evidence);
  return evidence;
}

}  // namespace af2::geometry
