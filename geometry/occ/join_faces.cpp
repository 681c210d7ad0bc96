#include "geometry/occ/join_faces.h"

#include <BRepAdaptor_Curve.hxx>
#include <algorithm>
#include <limits>

#include "geometry/occ/points.h"
#include "geometry/occ/sizing.h"

namespace af2::geometry {
namespace {

class Assembly {
 public:
  Assembly(const ModelShape& model, const DividedEdges& divided, const ModelMeshingOptions& options)
      : model_(model), divided_(divided), options_(options), sizes_(options.sizes) {}

  ModelMesh join(std::vector<FaceMesh>& faces) {
    numberBoundary(faces);
    for (FaceMesh& face : faces) add(face);
    addSegments(faces);
    takeSizesOfEdges();
    return std::move(mesh_);
  }

 private:
  static constexpr std::uint32_t kUnused = 0xffffffffu;

  void numberBoundary(const std::vector<FaceMesh>& faces) {
    ids_.assign(divided_.points.size(), kUnused);
    for (const FaceMesh& face : faces)
      for (const Element& element : face.elements)
        for (const VertexId v : element.vertices())
          if (v.value < face.boundary.size()) ids_[face.boundary[v.value]] = 0;
    for (std::size_t i = 0; i < ids_.size(); ++i)
      if (ids_[i] != kUnused) ids_[i] = addVertex(divided_.points[i]);
  }

  std::uint32_t addVertex(const Point3& position) {
    mesh_.vertices.push_back(position);
    mesh_.wantedSizes.push_back(std::numeric_limits<double>::infinity());
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }

  void add(FaceMesh& face) {
    const std::size_t boundaryCount = face.boundary.size();
    const std::size_t base = mesh_.vertices.size();
    mesh_.vertices.insert(mesh_.vertices.end(), face.inside.begin(), face.inside.end());
    mesh_.wantedSizes.insert(
        mesh_.wantedSizes.end(),
        face.wantedSizes.end() - static_cast<std::ptrdiff_t>(face.inside.size()),
        face.wantedSizes.end());
    for (std::size_t i = 0; i < boundaryCount && !face.wantedSizes.empty(); ++i) {
      const std::uint32_t id = ids_[face.boundary[i]];
      if (id != kUnused)
        mesh_.wantedSizes[id] = std::min(mesh_.wantedSizes[id], face.wantedSizes[i]);
    }
    for (Element element : face.elements) {
      for (VertexId& v : element.corners) {
        if (v.isNone()) continue;
        v = v.value < boundaryCount ? VertexId(ids_[face.boundary[v.value]])
                                    : VertexId(base + v.value - boundaryCount);
      }
      mesh_.elements.push_back(element);
      mesh_.face.push_back(face.report.id);
    }
    mesh_.rule.insert(mesh_.rule.end(), face.rule.begin(), face.rule.end());
    mesh_.faces.push_back(std::move(face.report));
  }

  void addSegments(const std::vector<FaceMesh>& faces) {
    std::vector<std::vector<int>> uses;
    for (const DividedEdge& edge : divided_.edges)
      uses.emplace_back(edge.points.empty() ? 0 : edge.points.size() - 1, 0);
    for (const FaceMesh& face : faces)
      for (const SegmentUse& use : face.uses)
        ++uses[static_cast<std::size_t>(use.edge) - 1][use.segment];
    for (std::size_t e = 0; e < uses.size(); ++e)
      for (std::size_t i = 0; i < uses[e].size(); ++i)
        if (uses[e][i] > 0) addSegment(e, i, uses[e][i]);
  }

  void addSegment(std::size_t edge, std::size_t i, int uses) {
    const DividedEdge& divided = divided_.edges[edge];
    EdgeSegment segment{VertexId(ids_[divided.points[i]]),
                        VertexId(ids_[divided.points[i + 1]]),
                        static_cast<int>(edge) + 1,
                        uses,
                        {}};
    if (options_.order == 2) {
      const double middle = (divided.parameters[i] + divided.parameters[i + 1]) / 2;
      const BRepAdaptor_Curve curve(model_.edge(segment.edge));
      segment.middle = toPoint(curve.Value(middle));
    }
    mesh_.segments.push_back(segment);
  }

  /// Along an edge with a size of its own those of its faces do not count.
  void takeSizesOfEdges() {
    if (sizes_.edgeSizes.empty()) return;
    for (const EdgeSegment& segment : mesh_.segments) {
      const auto own = sizes_.edgeSizes.find(segment.edge);
      if (own == sizes_.edgeSizes.end()) continue;
      for (const VertexId v : {segment.from, segment.to})
        mesh_.wantedSizes[v.value] = bounded(sizes_, own->second);
    }
  }

  const ModelShape& model_;
  const DividedEdges& divided_;
  const ModelMeshingOptions& options_;
  const ModelSizes& sizes_;
  std::vector<std::uint32_t> ids_;
  ModelMesh mesh_;
};

}  // namespace

ModelMesh joinFaces(const ModelShape& model, const DividedEdges& divided,
                    const ModelMeshingOptions& options, std::vector<FaceMesh>& faces) {
  return Assembly(model, divided, options).join(faces);
}

}  // namespace af2::geometry
