#include "geometry/occ/merge/quilt_filling.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "engine/base/error.h"
#include "geometry/base/constants.h"
#include "geometry/charts/flat_surface.h"
#include "geometry/fill/face_filling.h"
#include "geometry/mesh/face_history.h"
#include "geometry/occ/sizes/face_size.h"
#include "geometry/sizes/graded_size.h"

namespace af2::geometry {

namespace {

/// The sizes of the faces of a quilt. A narrow face is not followed, so its curvature does not
/// count. For one thread.
class QuiltSize final : public SizeField {
 public:
  QuiltSize(const CadSizes& sizes, const QuiltSurface& surface)
      : sizes_(sizes), surface_(surface), ofFaces_(surface.parts().faces.size()) {}

  double sizeAt(const SurfacePoint& point) const override {
    const QuiltSurface::OnFace on = surface_.onFace(point);
    const int face = surface_.parts().faces[on.index];
    SurfacePoint place = on.point;
    place.position = point.position;
    if (surface_.parts().isNarrow[on.index])
      return bounded(sizes_, limitByFunction(sizes_, wantedOnFace(sizes_, face), place.position));
    std::optional<FaceSize>& size = ofFaces_[on.index];
    if (!size) size.emplace(sizes_, face, surface_.surfaceOf(on.index));
    return size->sizeAt(place);
  }

 private:
  const CadSizes& sizes_;
  const QuiltSurface& surface_;
  mutable std::vector<std::optional<FaceSize>> ofFaces_;
};

/// The sizes on a plane, where points do not know their triangles.
class FlatSize final : public SizeField {
 public:
  FlatSize(const CadSizes& sizes, int face) : sizes_(sizes), wanted_(wantedOnFace(sizes, face)) {}
  double sizeAt(const SurfacePoint& point) const override {
    return bounded(sizes_, limitByFunction(sizes_, wanted_, point.position));
  }

 private:
  const CadSizes& sizes_;
  double wanted_;
};

class Filling {
 public:
  explicit Filling(const QuiltTask& task) : task_(task), surface_(task.quilt.parts) {
    const std::optional<FlatSurface> plane = task.quilt.parts->facets.plane();
    if (plane) flat_ = std::make_shared<const FlatSurface>(*plane);
  }

  void fill(FaceMesh& mesh) {
    FaceBoundary boundary = findBoundary();
    if (boundary.input.loops.empty()) {
      mesh.report.reason = "is smaller than any element, so it has none";
      mesh.report.area = 0;
      return;
    }
    addNotes(boundary.repairs, mesh.history);
    const double wantedSize = wantedOnFace(task_.sizes, firstFace());
    const std::unique_ptr<SizeField> wanted = makeSize(surface_);
    const GradedSize graded(*wanted, boundary.input, task_.sizes.growth);
    const UngradedSize ungraded(graded);
    const QuiltCharts charts(surface_);
    const ChartedSurface& surface = flat_ ? static_cast<const ChartedSurface&>(*flat_) : charts;
    const std::function<PieceTools(ChartKind)> tools = [&](ChartKind kind) {
      return makeTools(graded, kind);
    };
    fillAndJudge({{surface, boundary, graded, mesh.report.area, task_.expectedElements,
                   task_.request.algorithm, task_.request.options, task_.finer,
                   task_.request.limits, task_.request.progress, tools},
                  ungraded,
                  kUnseen * wantedSize,
                  task_.request.findMiddles,
                  [](std::vector<StuckPlace>& places) {
                    for (StuckPlace& place : places) place.u = place.v = 0;
                  },
                  [&](const SurfacePoint&) { return task_.sizes.minSize; },
                  [&] { return std::make_shared<const OwnUngraded>(*this, graded); }},
                 boundary, mesh);
    if (flat_) return;
    for (Point3& vertex : mesh.inside) vertex = surface_.settled(vertex);
  }

 private:
  int firstFace() const { return task_.quilt.parts->faces.front(); }

  std::unique_ptr<SizeField> makeSize(const QuiltSurface& surface) const {
    if (flat_) return std::make_unique<FlatSize>(task_.sizes, firstFace());
    return std::make_unique<QuiltSize>(task_.sizes, surface);
  }

  /// With a surface of its own, because the evaluators of faces are not to be shared.
  struct OwnSize final : SizeField {
    OwnSize(const Filling& filling, const GradedSize& shared)
        : surface(filling.surface_),
          charts(surface),
          wanted(filling.makeSize(surface)),
          graded(*wanted, shared) {}
    double sizeAt(const SurfacePoint& point) const override { return graded.sizeAt(point); }
    QuiltSurface surface;
    QuiltCharts charts;
    std::unique_ptr<SizeField> wanted;
    GradedSize graded;
  };

  struct OwnUngraded final : SizeField {
    OwnUngraded(const Filling& filling, const GradedSize& shared) : size(filling, shared) {}
    double sizeAt(const SurfacePoint& point) const override {
      return size.graded.ungradedAt(point);
    }
    OwnSize size;
  };

  PieceTools makeTools(const GradedSize& graded, ChartKind kind) const {
    auto size = std::make_shared<const OwnSize>(*this, graded);
    if (flat_) return {flat_->makeCharts(kind), std::move(size)};
    auto charts = size->charts.makeCharts(kind);
    return {std::move(charts), std::move(size)};
  }

  FaceBoundary findBoundary() {
    FaceBoundary boundary;
    collectPoints(boundary.points);
    for (const std::vector<QuiltUse>& loop : task_.quilt.boundary.loops) {
      std::vector<BoundaryCorner> corners;
      for (const QuiltUse& use : loop) addUse(use, boundary, corners);
      if (!corners.empty()) boundary.input.loops.push_back(std::move(corners));
    }
    boundary.input.vertexCount = boundary.points.size();
    boundary.closedInParameters = flat_ || surface_.isDrawn();
    boundary.canBeCut = flat_ != nullptr;
    return boundary;
  }

  const DividedEdge& dividedAs(const QuiltUse& use) const {
    const DividedEdge& edge = task_.request.divided.edges[static_cast<std::size_t>(use.edge) - 1];
    if (!edge.problem.empty()) throw GeometryError(edge.problem);
    return edge;
  }

  void collectPoints(std::vector<std::uint32_t>& points) const {
    for (const std::vector<QuiltUse>& loop : task_.quilt.boundary.loops)
      for (const QuiltUse& use : loop) {
        const std::vector<std::uint32_t>& own = dividedAs(use).points;
        points.insert(points.end(), own.begin(), own.end());
      }
    std::ranges::sort(points);
    points.erase(std::ranges::unique(points).begin(), points.end());
  }

  void addUse(const QuiltUse& use, FaceBoundary& boundary,
              std::vector<BoundaryCorner>& corners) const {
    const std::vector<std::uint32_t>& points = dividedAs(use).points;
    if (points.size() < 2) {
      boundary.pointEdges.push_back(use.edge);
      return;
    }
    const auto segments = static_cast<std::uint32_t>(points.size() - 1);
    for (std::uint32_t i = 0; i < segments; ++i) {
      const std::uint32_t segment = use.isReversed ? segments - 1 - i : i;
      const std::uint32_t point = points[use.isReversed ? segment + 1 : segment];
      const auto local = std::ranges::lower_bound(boundary.points, point);
      corners.push_back({VertexId(static_cast<std::size_t>(local - boundary.points.begin())),
                         onSurface(use, task_.request.divided.points[point])});
      boundary.uses.push_back({use.edge, segment});
    }
  }

  SurfacePoint onSurface(const QuiltUse& use, const Point3& position) const {
    SurfacePoint point =
        flat_ ? flat_->pointAt(position) : surface_.nearestAmong(use.triangles, position);
    point.position = position;
    return point;
  }

  const QuiltTask& task_;
  QuiltSurface surface_;
  std::shared_ptr<const FlatSurface> flat_;  ///< null: it is not plane
};

}  // namespace

void fillQuilt(const QuiltTask& task, FaceMesh& mesh) { Filling(task).fill(mesh); }

}  // namespace af2::geometry
