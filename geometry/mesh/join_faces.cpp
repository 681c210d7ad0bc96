#include "geometry/mesh/join_faces.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

#include "engine/base/parallel.h"
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

  /// By vertex of the boundary: whether the face has an element there.
  std::vector<bool> usedOnBoundary(const FaceMesh& face) const {
    if (face.bulk) return face.bulk->counts().isUsed;
    std::vector<std::atomic<bool>> isUsed(face.boundary.size());
    inRanges(face.elements.size(), [&](std::size_t i) {
      for (const VertexId v : face.elements[i].vertices())
        if (v.value < isUsed.size()) isUsed[v.value].store(true, std::memory_order_relaxed);
    });
    return {isUsed.begin(), isUsed.end()};
  }

  void numberBoundary(const std::vector<FaceMesh>& faces) {
    std::vector<std::vector<bool>> isUsed(faces.size());
    forEachInParallel(faces.size(), options_.threads,
                      [&](std::size_t i) { isUsed[i] = usedOnBoundary(faces[i]); });
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
    // At the same time: new memory takes as long to clear as to fill.
    const std::array<std::function<void()>, 5> arrays{
        [&] { mesh_.elements.resize(next.element); }, [&] { mesh_.vertices.resize(next.vertex); },
        [&] { mesh_.face.resize(next.element); }, [&] { mesh_.origins.resize(next.element); },
        [&] { mesh_.wantedSizes.resize(next.vertex); }};
    forEachInParallel(arrays.size(), options_.threads, [&](std::size_t i) { arrays[i](); });
  }

  /// Calls work(i) for 0 to count - 1; those of a large face on several threads.
  template <class Work>
  void inRanges(std::size_t count, const Work& work) const {
    constexpr std::size_t kAtOnce = 1 << 15;
    forEachInRanges(count, kAtOnce, options_.threads, work);
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
    const std::size_t vertex = starts_[index].vertex, element = starts_[index].element;
    const std::size_t firstInside = face.wantedSizes.size() - face.inside.size();
    inRanges(face.inside.size(), [&](std::size_t i) {
      mesh_.vertices[vertex + i] = face.inside[i];
      mesh_.wantedSizes[vertex + i] = face.wantedSizes[firstInside + i];
    });
    inRanges(face.elements.size(), [&](std::size_t i) {
      mesh_.origins[element + i] = face.origins[i];
      mesh_.face[element + i] = face.report.id;
      Element& placed = mesh_.elements[element + i];
      placed = face.elements[i];
      for (VertexId& v : placed.corners) {
        if (v.isNone()) continue;
        v = v.value < boundaryCount ? VertexId(ids_[face.boundary[v.value]])
                                    : VertexId(vertex + v.value - boundaryCount);
      }
    });
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
