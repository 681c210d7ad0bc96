// What becomes of a mesh after its faces were meshed together: each element is of a face again.
#include <BRepAdaptor_Curve.hxx>
#include <algorithm>
#include <limits>
#include <numeric>

#include "geometry/deviation/measured_mesh.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/merge/merged_faces.h"

namespace af2::geometry {

namespace {

Point3 middleOf(const ModelMesh& mesh, const Element& element) {
  Point3 sum;
  const auto corners = element.vertices();
  for (const VertexId v : corners) sum = sum + mesh.vertices[v.value];
  return (1.0 / static_cast<double>(corners.size())) * sum;
}

double farthest(const ModelMesh& mesh, const Element& element, FaceDistance& distance) {
  const auto at = [&](std::size_t i) { return mesh.vertices[element.corners[i].value]; };
  double largest = farthestOf(at(0), at(1), at(2), distance).distance;
  if (element.isQuad())
    largest = std::max(largest, farthestOf(at(0), at(2), at(3), distance).distance);
  return largest;
}

/// The distance of a place from an edge, at points along it.
double fromEdge(const ModelShape& shape, int edge, const Point3& place) {
  constexpr int kParts = 64;
  const BRepAdaptor_Curve curve(shape.edge(edge));
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kParts; ++i)
    nearest = std::min(nearest,
                       distance(place, toPoint(curve.Value(first + (last - first) * i / kParts))));
  return nearest;
}

template <class T>
void reorder(const std::vector<std::size_t>& order, std::vector<T>& values) {
  if (values.size() != order.size()) return;  // there are none
  std::vector<T> sorted;
  sorted.reserve(values.size());
  for (const std::size_t i : order) sorted.push_back(values[i]);
  values = std::move(sorted);
}

/// The elements of each face follow each other, as they do in all meshes.
void sortByFace(ModelMesh& mesh) {
  std::vector<std::size_t> order(mesh.elements.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return mesh.face[i]; });
  std::vector<std::size_t> placeOf(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) placeOf[order[i]] = i;
  reorder(order, mesh.elements);
  reorder(order, mesh.midsides);
  reorder(order, mesh.face);
  reorder(order, mesh.origins);
  reorder(order, mesh.scores);
  for (ElementId& element : mesh.straightened) element = ElementId(placeOf[element.value]);
  std::ranges::sort(mesh.straightened);
}

}  // namespace

void MergedFaces::spread(ModelMesh& mesh) const {
  mesh.merging = merging(mesh);
  std::vector<std::unique_ptr<QuiltSurface>> surfaces;
  for (const Quilt& quilt : plan_.quilts)
    surfaces.push_back(std::make_unique<QuiltSurface>(quilt.parts));
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    const auto found = plan_.quiltOf.find(mesh.face[i]);
    if (found == plan_.quiltOf.end()) continue;
    const QuiltSurface& surface = *surfaces[found->second];
    const FacetSurface& facets = surface.parts().facets;
    const FacetSurface::Place place =
        facets.placeOf(facets.nearest(middleOf(mesh, mesh.elements[i])));
    mesh.face[i] = surface.parts().faces[surface.parts().faceOf[place.triangle]];
  }
  sortByFace(mesh);
  spreadReports(mesh);
  spreadSegments(mesh);
}

void MergedFaces::spreadReports(ModelMesh& mesh) const {
  std::map<int, std::size_t> elements;
  for (const std::int32_t face : mesh.face) ++elements[face];
  for (FaceReport& report : mesh.faces) {
    const Quilt* quilt = quiltWith(report.id);
    if (!quilt) continue;
    const int first = quilt->parts->faces.front();
    const auto of = std::ranges::find(mesh.faces, first, &FaceReport::id);
    if (report.id != first) {
      report.status = of->status;
      report.chart = of->chart;
      report.reason.clear();
      report.cause = of->cause;
      if (report.status == FaceStatus::Failed) report.reason = of->reason;
      report.attempts = {"meshed together with face " + std::to_string(first)};
    }
    report.elements = elements[report.id];
    report.area = areaOfFace(report.id);
  }
}

/// A chain is divided as its first edge; each of its segments is of the edge nearest to its middle.
void MergedFaces::spreadSegments(ModelMesh& mesh) const {
  for (EdgeSegment& segment : mesh.segments) {
    const auto chain = std::ranges::find(merged().chains, segment.edge, &EdgeChain::id);
    if (chain == merged().chains.end()) continue;
    const Point3 middle =
        0.5 * (mesh.vertices[segment.from.value] + mesh.vertices[segment.to.value]);
    double least = std::numeric_limits<double>::infinity();
    for (const ChainLink& link : chain->links) {
      const double gap = fromEdge(shape(), link.edge, middle);
      if (!(gap < least)) continue;
      least = gap;
      segment.edge = link.edge;
    }
  }
}

Merging MergedFaces::merging(const ModelMesh& mesh) const {
  Merging merging{request_.angle, request_.narrow, {}, plan_.vertices, {}, {}};
  for (const EdgeChain& chain : merged().chains) {
    merging.chains.emplace_back();
    for (const ChainLink& link : chain.links) merging.chains.back().push_back(link.edge);
  }
  for (const Quilt& quilt : plan_.quilts) {
    if (quilt.parts->faces.size() < 2) continue;
    MergedGroup group{quilt.parts->faces, {}, {}, 0};
    for (std::size_t e = 0; e < merged().isRemoved.size(); ++e) {
      const int id = static_cast<int>(e) + 1;
      if (!merged().removes(e) ||
          !std::ranges::binary_search(group.faces, shape().facesOfEdges[e].front()))
        continue;
      const bool isNarrow = std::ranges::binary_search(plan_.besideNarrow, id);
      (isNarrow ? group.narrowEdges : group.smoothEdges).push_back(id);
    }
    const std::unique_ptr<FaceDistance> distance = distanceFrom(group.faces.front());
    for (std::size_t i = 0; i < mesh.elements.size(); ++i)
      if (mesh.face[i] == group.faces.front())
        group.deviation = std::max(group.deviation, farthest(mesh, mesh.elements[i], *distance));
    merging.groups.push_back(std::move(group));
  }
  for (const auto& [face, why] : plan_.kept) merging.kept.push_back({face, why});
  return merging;
}

}  // namespace af2::geometry
