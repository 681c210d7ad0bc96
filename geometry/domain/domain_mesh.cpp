#include <algorithm>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/base/constants.h"
#include "engine/base/error.h"
#include "geometry/base/constants.h"
#include "geometry/domain/crossed_faces.h"
#include "geometry/domain/domain_boundary.h"
#include "geometry/domain/domain_check.h"
#include "geometry/domain/domain_division.h"
#include "geometry/domain/domain_model.h"
#include "geometry/domain/face_memory.h"
#include "geometry/fill/face_filling.h"
#include "geometry/layers/layer_ends.h"
#include "geometry/layers/layers_of_face.h"
#include "geometry/layers/leave_out_layers.h"
#include "geometry/mesh/face_history.h"
#include "geometry/meshing/check_options.h"
#include "geometry/meshing/mesh_faces.h"
#include "geometry/sizes/loose_points.h"
#include "geometry/sizes/too_many.h"

namespace af2::geometry {

namespace {

/// The size on a face: what is wanted on it, but no more than curvature and position allow.
class FaceWanted final : public SizeField {
 public:
  FaceWanted(const DomainSize& byPosition, double size, const CurvatureLimit* limit)
      : byPosition_(byPosition), size_(size), limit_(limit) {}
  double sizeAt(const SurfacePoint& point) const override {
    const double size = limit_ ? std::min(size_, limit_->sizeAt(point)) : size_;
    return byPosition_.at(point.position, size);
  }

 private:
  const DomainSize& byPosition_;
  double size_;
  const CurvatureLimit* limit_;
};

/// Sizes that grow away from points which are to be vertices.
class NearLoosePoints final : public SizeField {
 public:
  /// near  null: there are none
  NearLoosePoints(const SizeField& wanted, const GrowingSize* near)
      : wanted_(wanted), near_(near) {}
  double sizeAt(const SurfacePoint& point) const override {
    const double size = wanted_.sizeAt(point);
    return near_ ? std::min(size, near_->at(point.position)) : size;
  }

 private:
  const SizeField& wanted_;
  const GrowingSize* near_;
};

class FromNearest final : public FaceDistance {
 public:
  explicit FromNearest(const DomainFace& face) : face_(face) {}
  double of(const Point3& point) override { return distance(point, face_.nearest(point).position); }

 private:
  const DomainFace& face_;
};

class DomainFaces final : public FaceSource {
 public:
  explicit DomainFaces(const DomainModel& model) : model_(model) {}

  int faceCount() const override { return static_cast<int>(model_.faces.size()); }
  int edgeCount() const override {
    int edges = 0;
    for (const DomainCurve& curve : model_.curves) edges = std::max(edges, curve.id);
    return edges;
  }
  double diagonal() const override { return model_.diagonal; }
  const std::vector<FaceGroup>& groups() const override { return model_.groups; }
  const std::vector<EdgeGroup>& boundaries() const override { return model_.boundaries; }
  std::vector<int> edgeIdsOf(int face) const override {
    std::vector<int> ids;
    for (const auto& loop : at(face).loops)
      for (const CurveUse& use : loop) ids.push_back(model_.curves[use.curve].id);
    std::ranges::sort(ids);
    return ids;
  }

  FaceReport reportOf(int id) const override {
    const DomainFace& face = at(id);
    FaceReport report;
    report.id = id;
    report.name = face.name;
    report.surfaceType = face.surfaceType;
    report.area = face.area;
    return report;
  }

  void prepare(const MeshingOptions& options, const std::vector<int>& faces) override {
    options_ = &options;
    checkPoints(model_, options.edgePoints);
    findSizes();
    findRoom();
    findLayers(faces);
    std::vector<double> elements;
    for (const int face : faces) elements.push_back(workOn(face));
    refuseTooMany(elements, memoryLimitOf(options));
  }

  double workOn(int face) const override {
    return 1 + expectedOn(face, bounded(options_->sizes, sizes_->onFace[indexOf(face)]));
  }

  const PositionSize& sizesByPosition() const override { return options_->sizes.function; }

  /// Each curve is an edge, whichever edge of the model it is part of.
  std::vector<int> edgesOf(int face) const override {
    std::vector<int> edges;
    for (const auto& loop : at(face).loops)
      for (const CurveUse& use : loop) edges.push_back(static_cast<int>(use.curve) + 1);
    std::ranges::sort(edges);
    edges.erase(std::ranges::unique(edges).begin(), edges.end());
    return edges;
  }
  int idOfEdge(int divided) const override { return curveOf(divided).id; }
  Point3 pointOnEdge(int divided, double parameter) const override {
    return curveOf(divided).pointAt(parameter);
  }

  std::unique_ptr<FaceDistance> distanceFrom(int face) const override {
    const DomainFace& of = at(face);
    return of.surface->isPlane() ? nullptr : std::make_unique<FromNearest>(of);
  }

  /// Invisible edges were removed when the model was made, so no edges are collapsed to points.
  DividedEdges divide(const PositionSize& sizes, const CollapsedEdges&,
                      const SegmentChanges& changes) const override {
    DomainSizes own = *sizes_;
    own.byPosition = sizes_->byPosition.withFunction(sizes);
    return divideCurves(model_, own, options_->sizes.growth, options_->edgePoints, changes,
                        layerEnds_);
  }

  std::vector<CountedLoop> loopsOf(int face, const DividedEdges& divided) const override {
    std::vector<CountedLoop> loops;
    for (const auto& loop : at(face).loops) {
      CountedLoop& counted = loops.emplace_back();
      for (const CurveUse& use : loop)
        counted.counts.push_back(divided.edges[use.curve].counts.front());
    }
    return loops;
  }

  void fill(int id, const FillRequest& request, FaceMesh& mesh) const override {
    FaceBoundary boundary = boundaryOf(at(id), request.divided);
    addNotes(boundary.repairs, mesh.history);
    leaveOutLayersOf(id, request, boundary);
    const std::optional<FaceMemory::Key> key = keyOf(id, request, boundary);
    if (!key) return fill(id, request, boundary, mesh);
    std::shared_ptr<const FaceMemory::Filled> filled = model_.memory->find(*key);
    const bool isKnown = filled != nullptr;
    if (!isKnown) filled = remembered(id, request, boundary, *key);
    take(*filled, boundary, mesh);
    if (isKnown) mesh.optimizeSeconds = 0;
    if (filled->failure) std::rethrow_exception(filled->failure);
  }

  /// Others are spread over the surface already.
  std::vector<SizeSource> sizesInside(int face) const override {
    const CurvatureLimit* limit = limitOf(face);
    return limit ? limit->sizesToFollow() : std::vector<SizeSource>();
  }

  bool mayCross() const override { return !model_.isExact; }
  double retryShare() const override { return model_.retryShare; }
  bool mayTilt() const override { return model_.mayTilt; }

  bool meetsOthers(int face, const std::vector<Crossing>& crossings) const override {
    return model_.crossings && crossInModel(model_.crossings(), face, crossings);
  }

  void complete(const MeshFaults&, ModelMesh& mesh) const override {
    mesh.boundaries = model_.boundaries;
    mesh.notes = model_.notes;
    const auto failed = [](const FaceReport& face) { return face.status == FaceStatus::Failed; };
    if (model_.crossings && std::ranges::any_of(mesh.faces, failed))
      tellOfCrossings(model_.crossings(), mesh.faces);
  }

 private:
  void fill(int id, const FillRequest& request, FaceBoundary& boundary, FaceMesh& mesh) const {
    const DomainFace& face = at(id);
    const double area = face.area - (boundary.layers ? boundary.layers->area : 0);
    const DomainSize byPosition = sizes_->byPosition.withFunction(request.sizes);
    const CurvatureLimit* limit = limitOf(id);
    const double size = sizes_->onFace[indexOf(id)];
    const FaceWanted wanted(byPosition, size, limit);
    const NearLoosePoints near(wanted, sizes_->nearLoosePoints.get());
    const GradedSize graded(near, boundary.input, options_->sizes.growth);
    const std::function<PieceTools(ChartKind)> tools = [&](ChartKind kind) {
      // Nothing here is changed by use, so that all threads may share it.
      return PieceTools{face.surface->makeCharts(kind),
                        std::shared_ptr<const SizeField>(std::shared_ptr<void>(), &graded)};
    };
    const double expected = expectedOn(id, size);
    // What curvature allows is in the expected number of elements, if a face has such a limit.
    const bool mayTurn = options_->sizes.elementsPerTurn > 0 && !limit;
    const FinerInside finer = mayTurn ? kAnySizes : sizes_->finer;
    const auto withoutParameters = [](std::vector<StuckPlace>& places) {
      for (StuckPlace& place : places) place.u = place.v = 0;
    };
    fillAndJudge(
        {{*face.surface, boundary, graded, area, expected, request.algorithm, request.options,
          finer, request.limits, request.progress, tools, limit && request.limits.hasOriginalSizes},
         wanted,
         kUnseen * size,
         request.findMiddles,
         face.surface->isPlane() ? std::function<void(std::vector<StuckPlace>&)>()
                                 : withoutParameters,
         [&](const SurfacePoint&) { return options_->sizes.minSize; }},
        boundary, mesh);
  }

  /// What the mesh of a face depends on besides its surface and what is the same whenever the model
  /// is meshed; nothing if it is not to be remembered.
  std::optional<FaceMemory::Key> keyOf(int id, const FillRequest& request,
                                       const FaceBoundary& boundary) const {
    const bool isPlain = request.sizes.isSameAs(options_->sizes.function) && !boundary.layers &&
                         boundary.fans.empty();
    // Observers want to see each front, and all processes of a crew must take part in the same.
    const bool isAlone = !request.options.observer && !request.options.crew;
    if (!model_.memory || !isPlain || !isAlone) return std::nullopt;
    FaceMemory::Key key{at(id).surface, {}};
    if (const CurvatureLimit* limit = limitOf(id)) {
      std::optional<std::vector<double>> own = limit->numbers();
      if (!own) return std::nullopt;
      key.numbers = *std::move(own);
    }
    const TryLimits& limits = request.limits;
    for (const double number :
         {static_cast<double>(limits.maxCandidates), limits.ignoresNormals + 0.,
          limits.refusesReflex + 0., limits.failedBefore + 0., limits.hasOriginalSizes + 0.,
          sizes_->onFace[indexOf(id)], static_cast<double>(boundary.input.vertexCount),
          boundary.closedInParameters + 0., boundary.canBeCut + 0.})
      key.numbers.push_back(number);
    for (const auto& loop : boundary.input.loops) key.add(loop);
    key.add(boundary.input.isolated);
    return key;
  }

  std::shared_ptr<const FaceMemory::Filled> remembered(int id, const FillRequest& request,
                                                       FaceBoundary boundary,
                                                       const FaceMemory::Key& key) const {
    const auto filled = std::make_shared<FaceMemory::Filled>();
    try {
      fill(id, request, boundary, filled->mesh);
    } catch (const GeometryError&) {
      filled->failure = std::current_exception();
    } catch (const InputError&) {
      filled->failure = std::current_exception();
    }
    filled->mesh.boundary.clear();
    filled->mesh.uses.clear();
    if (!request.options.stop.stop_requested()) model_.memory->keep(key, filled);
    return filled;
  }

  /// All that `fill` finds.
  static void take(const FaceMemory::Filled& filled, FaceBoundary& boundary, FaceMesh& mesh) {
    FaceReport report = std::move(mesh.report);
    FaceHistory history = std::move(mesh.history);
    history.insert(history.end(), filled.mesh.history.begin(), filled.mesh.history.end());
    mesh = filled.mesh;
    mesh.history = std::move(history);
    mesh.report.id = report.id;
    mesh.report.name = std::move(report.name);
    mesh.report.surfaceType = std::move(report.surfaceType);
    mesh.report.area = report.area;
    if (filled.failure) return;
    mesh.boundary = std::move(boundary.points);
    mesh.uses = std::move(boundary.uses);
  }

  static std::size_t indexOf(int face) { return static_cast<std::size_t>(face) - 1; }
  const DomainFace& at(int face) const { return model_.faces[indexOf(face)]; }
  /// Null: the face is plane.
  const CurvatureLimit* limitOf(int face) const {
    return sizes_->byCurvature.ofFaces[indexOf(face)].get();
  }
  const DomainCurve& curveOf(int divided) const {
    return model_.curves[static_cast<std::size_t>(divided) - 1];
  }

  void findSizes() {
    const Sizes& asked = options_->sizes;
    sizes_ = DomainSizes{DomainSize(asked), {}, asked.edgeSizes, nullptr, {}, finerInside(asked)};
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      const auto given = asked.faceSizes.find(static_cast<int>(f) + 1);
      const double size = given == asked.faceSizes.end() ? asked.size : given->second;
      sizes_->onFace.push_back(std::min(size, model_.faces[f].largest));
    }
    sizes_->byCurvature.ofFaces.resize(model_.faces.size());
    if (model_.curvatureLimits) sizes_->byCurvature = model_.curvatureLimits(sizes_->byPosition);
  }

  /// Of the faces to be meshed, with the places at which they end on other edges.
  void findLayers(const std::vector<int>& faces) {
    layers_.clear();
    layerEnds_.clear();
    if (options_->layers.empty()) return;
    for (const int face : faces) {
      const EdgeLayers byId = layersOfFace(options_->layers, face, edgeIdsOf(face));
      for (const int curve : edgesOf(face))
        if (const auto own = byId.find(idOfEdge(curve)); own != byId.end())
          layers_[face][curve] = own->second;
    }
    const DividedEdges divided = divide(sizesByPosition(), {}, {});
    for (const auto& [face, layers] : layers_)
      addLayerEnds(boundaryOf(at(face), divided), layers, divided, layerEnds_);
    fitLayerEnds(divided, layerEnds_);
  }

  void leaveOutLayersOf(int id, const FillRequest& request, FaceBoundary& boundary) const {
    const auto own = layers_.find(id);
    if (own == layers_.end()) return;
    const DomainFace& face = at(id);
    const auto place = [&](const SurfacePoint& point, double, double) {
      SurfacePoint placed = face.nearest(point.position);
      placed.position = point.position;
      return placed;
    };
    leaveOutLayers(*face.surface, place, own->second, request.divided,
                   stepsFor(request.options.quads), boundary);
    if (!boundary.layers) return;
    for (LayersAlongEdge& along : boundary.layers->along) along.edge = idOfEdge(along.edge);
  }

  /// Between points that are to be vertices, and between these and the curves around them.
  void findRoom() {
    std::vector<SizeSource> sources;
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      const DomainFace& face = model_.faces[f];
      if (face.isolated.empty()) continue;
      std::vector<Point3> points;
      for (const std::size_t corner : face.isolated) points.push_back(model_.corners[corner]);
      std::vector<std::pair<Point3, Point3>> chords;
      for (const auto& loop : face.loops)
        for (const CurveUse& use : loop) addChords(model_.curves[use.curve], chords);
      for (const SizeSource& source : roomAround(points, chords))
        if (source.size < sizes_->onFace[f]) sources.push_back(source);
    }
    if (sources.empty()) return;
    sizes_->finer = sizes_->finer +
                    finerAround(sources, options_->sizes.growth, std::ranges::max(sizes_->onFace));
    sizes_->nearLoosePoints = std::make_shared<const GrowingSize>(
        std::move(sources), options_->sizes.growth, DomainCurve::kNoLimit);
  }

  static void addChords(const DomainCurve& curve, std::vector<std::pair<Point3, Point3>>& chords) {
    for (std::size_t k = 1; k < curve.knots.size(); ++k)
      chords.emplace_back(curve.pointAt(curve.knots[k - 1]), curve.pointAt(curve.knots[k]));
  }

  /// How many elements a face takes if nothing but its size and its curvature counts.
  double expectedOn(int face, double size) const {
    if (const CurvatureLimit* limit = limitOf(face)) return limit->expectedElements(size);
    return at(face).area / (kUnitTriangle * size * size);
  }

  const DomainModel& model_;
  const MeshingOptions* options_ = nullptr;
  std::optional<DomainSizes> sizes_;  // once prepared
  std::map<int, EdgeLayers> layers_;  // by face, and number of the curve from 1
  LayerEnds layerEnds_;
};

}  // namespace

ModelMesh meshDomain(const DomainModel& model, const AF2Algorithm& algorithm,
                     const MeshingOptions& options) {
  checkDomain(model);
  DomainFaces faces(model);
  return meshFaces(faces, algorithm, options);
}

}  // namespace af2::geometry
