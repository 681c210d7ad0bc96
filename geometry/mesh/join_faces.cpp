#include "geometry/mesh/join_faces.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "geometry/base/parallel.h"
#include "geometry/spool/spooled_mesh.h"

namespace af2::geometry {
namespace {

class Assembly {
 public:
  Assembly(const DividedEdges& divided, const JoinOptions& options)
      : divided_(divided), options_(options) {}

  ModelMesh join(const std::vector<FaceMesh>& faces) {
    numberBoundary(faces);
    if (options_.spool) {
      takeSpooled(faces);
    } else {
      makeRoom(faces);
      forEachInParallel(faces.size(), options_.threads, [&](std::size_t i) { place(faces[i], i); });
    }
    for (const FaceMesh& face : faces) {
      takeSizesOfBoundary(face);
      mesh_.faces.push_back(face.report);
    }
    addSegments(faces);
    takeSizesOfEdges();
    return std::move(mesh_);
  }

 private:
  static constexpr std::uint32_t kUnused = 0xffffffffu;

  void numberBoundary(const std::vector<FaceMesh>& faces) {
    std::vector<std::vector<bool>> isUsed(faces.size());  // by vertex of the boundary
    forEachInParallel(faces.size(), options_.threads, [&](std::size_t i) {
      if (faces[i].bulk) {
        isUsed[i] = faces[i].bulk->counts().isUsed;
        return;
      }
      isUsed[i].assign(faces[i].boundary.size(), false);
      for (const Element& element : faces[i].elements)
        for (const VertexId v : element.vertices())
          if (v.value < isUsed[i].size()) isUsed[i][v.value] = true;
    });
    ids_.assign(divided_.points.size(), kUnused);
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::size_t v = 0; v < isUsed[i].size(); ++v)
        if (isUsed[i][v]) ids_[faces[i].boundary[v]] = 0;
    // Also where no element has kept a segment: the checks find that, and need its ends.
    for (const FaceMesh& face : faces)
      for (const SegmentUse& use : face.uses) {
        const auto& points = divided_.edges[static_cast<std::size_t>(use.edge) - 1].points;
        ids_[points[use.segment]] = ids_[points[use.segment + 1]] = 0;
      }
    for (std::size_t i = 0; i < ids_.size(); ++i)
      if (ids_[i] != kUnused) ids_[i] = addVertex(divided_.points[i]);
  }

  /// Where the vertices inside a face and its elements begin, in the order of the faces.
  struct Start {
    std::size_t vertex, element;
  };

  void makeRoom(const std::vector<FaceMesh>& faces) {
    Start next{mesh_.vertices.size(), 0};
    for (const FaceMesh& face : faces) {
      starts_.push_back(next);
      next.vertex += face.inside.size();
      next.element += face.elements.size();
    }
    mesh_.vertices.resize(next.vertex);
    mesh_.wantedSizes.resize(next.vertex);
    mesh_.elements.resize(next.element);
    mesh_.face.resize(next.element);
    mesh_.origins.resize(next.element);
  }

  void takeSpooled(const std::vector<FaceMesh>& faces) {
    std::vector<SpooledPart> parts;
    for (const FaceMesh& face : faces) {
      if (!face.bulk) continue;
      SpooledPart& part = parts.emplace_back(SpooledPart{face.report.id, face.bulk, face.boundary});
      for (std::uint32_t& point : part.boundary) point = ids_[point];
    }
    mesh_.spooled = std::make_shared<const SpooledMesh>(std::move(parts), mesh_.vertices.size(),
                                                        options_.spool);
  }

  std::uint32_t addVertex(const Point3& position) {
    mesh_.vertices.push_back(position);
    mesh_.wantedSizes.push_back(std::numeric_limits<double>::infinity());
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }

  void place(const FaceMesh& face, std::size_t index) {
    const std::size_t boundaryCount = face.boundary.size();
    const auto [vertex, element] = starts_[index];
    const auto at = [](auto& all, std::size_t i) {
      return all.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::copy(face.inside.begin(), face.inside.end(), at(mesh_.vertices, vertex));
    std::copy(face.wantedSizes.end() - static_cast<std::ptrdiff_t>(face.inside.size()),
              face.wantedSizes.end(), at(mesh_.wantedSizes, vertex));
    std::copy(face.origins.begin(), face.origins.end(), at(mesh_.origins, element));
    std::fill_n(at(mesh_.face, element), face.elements.size(), face.report.id);
    for (std::size_t i = 0; i < face.elements.size(); ++i) {
      Element& placed = mesh_.elements[element + i];
      placed = face.elements[i];
      for (VertexId& v : placed.corners) {
        if (v.isNone()) continue;
        v = v.value < boundaryCount ? VertexId(ids_[face.boundary[v.value]])
                                    : VertexId(vertex + v.value - boundaryCount);
      }
    }
  }

  /// On an edge that faces share, the smallest of what they want counts.
  void takeSizesOfBoundary(const FaceMesh& face) {
    if (face.wantedSizes.empty()) return;
    for (std::size_t i = 0; i < face.boundary.size(); ++i) {
      const std::uint32_t id = ids_[face.boundary[i]];
      if (id != kUnused)
        mesh_.wantedSizes[id] = std::min(mesh_.wantedSizes[id], face.wantedSizes[i]);
    }
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
    if (options_.pointOnEdge)
      segment.middle = options_.pointOnEdge(
          segment.edge, (divided.parameters[i] + divided.parameters[i + 1]) / 2);
    mesh_.segments.push_back(segment);
  }

  /// Along an edge with a size of its own those of its faces do not count.
  void takeSizesOfEdges() {
    if (options_.edgeSizes.empty()) return;
    for (const EdgeSegment& segment : mesh_.segments) {
      const auto own = options_.edgeSizes.find(segment.edge);
      if (own == options_.edgeSizes.end()) continue;
      for (const VertexId v : {segment.from, segment.to}) mesh_.wantedSizes[v.value] = own->second;
    }
  }

  const DividedEdges& divided_;
  const JoinOptions& options_;
  std::vector<std::uint32_t> ids_;  ///< by point of the divided edges
  std::vector<Start> starts_;       ///< by face
  ModelMesh mesh_;
};

}  // namespace

ModelMesh joinFaces(const DividedEdges& divided, const std::vector<FaceMesh>& faces,
                    const JoinOptions& options) {
  return Assembly(divided, options).join(faces);
}

}  // namespace af2::geometry
