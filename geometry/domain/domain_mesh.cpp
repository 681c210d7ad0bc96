#include <algorithm>
#include <cmath>
#include <mutex>
#include <new>
#include <numeric>

#include "engine/base/error.h"
#include "engine/base/stopwatch.h"
#include "geometry/base/parallel.h"
#include "geometry/check/sound_faces.h"
#include "geometry/domain/domain_boundary.h"
#include "geometry/domain/domain_check.h"
#include "geometry/domain/domain_division.h"
#include "geometry/domain/domain_model.h"
#include "geometry/domain/part_sizes.h"
#include "geometry/fill/face_filling.h"
#include "geometry/mesh/inside_out.h"
#include "geometry/mesh/join_faces.h"
#include "geometry/mesh/narrow_places.h"
#include "geometry/retry/retries.h"
#include "geometry/sizes/loose_points.h"
#include "geometry/sizes/too_many.h"

namespace af2::geometry {

namespace {

/// What is narrower than this share of the wanted size is not to be seen in the mesh.
constexpr double kUnseen = 5e-5;
constexpr double kUnitTriangle = 0.4330127018922193;  // area of the one with edges of length 1

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

/// Elements of all faces together, told one call at a time.
class ElementCount {
 public:
  ElementCount(const ProgressCallback& tell, std::size_t faces) : tell_(tell), byFace_(faces, 0) {}

  ProgressCallback of(std::size_t face) {
    return [this, face](const Progress& progress) {
      if (!tell_) return;
      const std::lock_guard lock(mutex_);
      sum_.elements += progress.elements - byFace_[face];
      byFace_[face] = progress.elements;
      tell_(sum_);
    };
  }

 private:
  const ProgressCallback& tell_;
  std::vector<std::size_t> byFace_;
  Progress sum_;
  std::mutex mutex_;
};

class DomainMesher final : public RetriedModel {
 public:
  DomainMesher(const DomainModel& model, const AF2Algorithm& algorithm,
               const DomainMeshingOptions& options)
      : model_(model),
        algorithm_(algorithm),
        options_(options),
        sizes_{DomainSize(options), {}, options.edgeSizes, nullptr, {}} {
    for (const DomainCurve& curve : model.curves) idOfCurve_.push_back(curve.id);
    findSizes();
    findRoom();
    findFaces();
    refuseTooMany();
  }

  ModelMesh mesh() {
    const Stopwatch edgesWatch;
    FaceMeshes state;
    state.divided = divide(options_.function, {});
    const double edgeSeconds = edgesWatch.seconds();
    const Stopwatch facesWatch;
    meshFaces(state);
    RetryOptions retries{options_.function, largestAsked(), options_.growth, threads(),
                         options_.stop};
    retries.share = model_.retryShare;
    if (options_.mostRetries) retries.mostRounds = *options_.mostRetries;
    retryPoorFaces(*this, retries, state);
    const double share = shareOfOptimizing(state.meshes), seconds = facesWatch.seconds();
    ModelMesh mesh = finished(state);
    mesh.seconds.edges = edgeSeconds;
    mesh.seconds.optimize = share * seconds;
    mesh.seconds.surface = seconds - mesh.seconds.optimize;
    return mesh;
  }

  const std::vector<std::vector<int>>& edgesOfFaces() const override { return edgesOfFaces_; }

  DividedEdges divide(const PositionSize& sizes, const EdgesAsPoints&) const override {
    DomainSizes own = sizes_;
    own.byPosition = sizes_.byPosition.withFunction(sizes);
    return divideCurves(model_, own, options_.growth, options_.edgePoints);
  }

  void mesh(std::size_t i, const PositionSize& sizes, const TryLimits& limits,
            FaceMeshes& into) const override {
    into.meshes[i] = meshed(i, sizes, limits, into.divided, {});
  }

  void join(FaceMeshes& state) const override {
    JoinOptions join;
    join.threads = options_.threads;
    for (std::size_t c = 0; c < model_.curves.size(); ++c)
      if (const auto own = options_.edgeSizes.find(idOfCurve_[c]); own != options_.edgeSizes.end())
        join.edgeSizes[static_cast<int>(c) + 1] = sizes_.byPosition.bounded(own->second);
    if (options_.order == 2)
      join.pointOnEdge = [&](int edge, double parameter) {
        return model_.curves[static_cast<std::size_t>(edge) - 1].pointAt(parameter);
      };
    state.joined = joinFaces(state.divided, state.meshes, join);
    const bool mayCross = !model_.isExact && !options_.stop.stop_requested();
    state.faults = faultsOf(state.joined, mayCross, options_.threads);
  }

  /// What cannot be seen is no edge from the beginning.
  std::vector<EdgesAsPoints> shortEdges(std::size_t, const DividedEdges&,
                                        const std::vector<SizeSource>&) const override {
    return {};
  }

  /// Others are spread over the surface already.
  std::vector<SizeSource> sizesInside(std::size_t i) const override {
    const CurvatureLimit* limit = sizes_.limits[static_cast<std::size_t>(faces_[i]) - 1].get();
    return limit ? limit->sizesToFollow() : std::vector<SizeSource>();
  }

 private:
  const DomainFace& faceAt(std::size_t i) const {
    return model_.faces[static_cast<std::size_t>(faces_[i]) - 1];
  }

  void findSizes() {
    std::vector<std::string> names;
    for (const DomainFace& face : model_.faces) names.push_back(face.name);
    std::map<int, double> own = sizesByName(options_.partSizes, names, model_.groups);
    for (const auto& [face, size] : options_.faceSizes) own[face] = size;
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      const auto given = own.find(static_cast<int>(f) + 1);
      const double size = given == own.end() ? options_.size : given->second;
      sizes_.onFace.push_back(std::min(size, model_.faces[f].largest));
    }
    sizes_.limits.resize(model_.faces.size());
    if (model_.limitsOfFaces) sizes_.limits = model_.limitsOfFaces(sizes_.byPosition);
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
        if (source.size < sizes_.onFace[f]) sources.push_back(source);
    }
    if (sources.empty()) return;
    sizes_.nearLoosePoints = std::make_shared<const GrowingSize>(
        std::move(sources), options_.growth, DomainCurve::kNoLimit);
  }

  static void addChords(const DomainCurve& curve, std::vector<std::pair<Point3, Point3>>& chords) {
    for (std::size_t k = 1; k < curve.knots.size(); ++k)
      chords.emplace_back(curve.pointAt(curve.knots[k - 1]), curve.pointAt(curve.knots[k]));
  }

  void findFaces() {
    faces_ = options_.faces;
    if (faces_.empty()) {
      faces_.resize(model_.faces.size());
      std::iota(faces_.begin(), faces_.end(), 1);
    }
    std::ranges::sort(faces_);
    faces_.erase(std::ranges::unique(faces_).begin(), faces_.end());
    for (const int face : faces_) {
      std::vector<int>& edges = edgesOfFaces_.emplace_back();
      for (const auto& loop : model_.faces[static_cast<std::size_t>(face) - 1].loops)
        for (const CurveUse& use : loop) edges.push_back(static_cast<int>(use.curve) + 1);
      std::ranges::sort(edges);
      edges.erase(std::ranges::unique(edges).begin(), edges.end());
    }
  }

  /// How many elements a face takes if nothing but its size and its curvature counts.
  double expectedOn(int face, double size) const {
    const auto index = static_cast<std::size_t>(face) - 1;
    if (const CurvatureLimit* limit = sizes_.limits[index].get())
      return limit->expectedElements(size);
    return model_.faces[index].area / (kUnitTriangle * size * size);
  }

  void refuseTooMany() const {
    double elements = 0;
    for (const int face : faces_)
      elements += expectedOn(
          face, sizes_.byPosition.bounded(sizes_.onFace[static_cast<std::size_t>(face) - 1]));
    geometry::refuseTooMany(elements);
  }

  double largestAsked() const {
    double largest = options_.size;
    for (const double size : sizes_.onFace) largest = std::max(largest, size);
    for (const auto& [edge, size] : sizes_.onEdge) largest = std::max(largest, size);
    return largest;
  }

  void meshFaces(FaceMeshes& state) const {
    state.meshes.resize(faces_.size());
    ElementCount count(options_.progress, faces_.size());
    forEachInParallel(faces_.size(), threads(), [&](std::size_t i) {
      state.meshes[i] = meshed(i, options_.function, {std::numeric_limits<std::size_t>::max()},
                               state.divided, count.of(i));
    });
  }

  int threads() const { return options_.observer ? 1 : options_.threads; }

  FaceMesh meshed(std::size_t i, const PositionSize& sizes, const TryLimits& limits,
                  const DividedEdges& divided, const ProgressCallback& progress) const {
    const Stopwatch watch;
    const DomainFace& face = faceAt(i);
    FaceMesh mesh;
    mesh.report.id = faces_[i];
    mesh.report.name = face.name;
    mesh.report.surfaceType = face.surfaceType;
    mesh.report.area = face.area;
    if (options_.stop.stop_requested()) {
      mesh.report.status = FaceStatus::Cancelled;
      return mesh;
    }
    try {
      fill(i, sizes, limits, divided, progress, mesh);
    } catch (const std::runtime_error& error) {  // of the surface or the boundary
      failFor(error.what(), mesh);
    } catch (const std::bad_alloc&) {
      failFor("there is not enough memory; ask for a larger size", mesh);
    }
    mesh.report.seconds = watch.seconds();
    return mesh;
  }

  void fill(std::size_t i, const PositionSize& sizes, const TryLimits& limits,
            const DividedEdges& divided, const ProgressCallback& progress, FaceMesh& mesh) const {
    const DomainFace& face = faceAt(i);
    const auto index = static_cast<std::size_t>(faces_[i]) - 1;
    FaceBoundary boundary = boundaryOf(face, divided);
    mesh.report.attempts = boundary.repairs;
    const DomainSize byPosition = sizes_.byPosition.withFunction(sizes);
    const CurvatureLimit* limit = sizes_.limits[index].get();
    const double size = sizes_.onFace[index];
    const FaceWanted wanted(byPosition, size, limit);
    const NearLoosePoints near(wanted, sizes_.nearLoosePoints.get());
    const GradedSize graded(near, boundary.input, options_.growth);
    const FillOptions options{options_.chart, options_.optimize, options_.stop,
                              [&] { return options_.observer; }};
    const std::function<PieceTools(ChartKind)> tools = [&](ChartKind kind) {
      // Nothing here is changed by use, so that all threads may share it.
      return PieceTools{face.surface->makeCharts(kind),
                        std::shared_ptr<const SizeField>(std::shared_ptr<void>(), &graded)};
    };
    const double expected = expectedOn(faces_[i], size);
    // The last way is tried with the sizes of the beginning.
    const bool hasOwnSizes = &sizes == &options_.function || limits.mayLean;
    const bool mayBeFine = sizes_.byPosition.isVaried() || options_.elementsPerTurn > 0 ||
                           sizes_.nearLoosePoints != nullptr;
    const auto withoutParameters = [](std::vector<StuckPlace>& places) {
      for (StuckPlace& place : places) place.u = place.v = 0;
    };
    fillInto({{*face.surface, boundary, graded, face.area, expected, algorithm_, options, mayBeFine,
               limits.mostCandidates, limits.mayLean, progress, tools, limit && hasOwnSizes},
              wanted,
              kUnseen * size,
              options_.order == 2,
              face.surface->isPlane() ? std::function<void(std::vector<StuckPlace>&)>()
                                      : withoutParameters},
             boundary, mesh);
  }

  ModelMesh finished(FaceMeshes& state) const {
    const MiddlesByFace middles = takeMiddles(state.meshes);
    ModelMesh mesh = std::move(state.joined);
    for (EdgeSegment& segment : mesh.segments)
      segment.edge = idOfCurve_[static_cast<std::size_t>(segment.edge) - 1];
    for (const AF2Rule& rule : algorithm_.rules().rules()) mesh.ruleNames.push_back(rule.name());
    mesh.ruleNames.push_back("closing");  // what closes a stuck front
    mesh.groups = model_.groups;
    mesh.boundaries = model_.boundaries;
    mesh.notes = model_.notes;
    mesh.findings = keepSoundFaces(mesh, state.faults);
    if (isInsideOut(mesh)) mesh.notes.emplace_back(kInsideOut);
    if (options_.order == 2) makeSecondOrder(mesh, middlesOf(mesh, middles));
    return mesh;
  }

  const DomainModel& model_;
  const AF2Algorithm& algorithm_;
  const DomainMeshingOptions& options_;
  DomainSizes sizes_;
  std::vector<int> faces_;                      // that were asked for
  std::vector<std::vector<int>> edgesOfFaces_;  // by face that was asked for; [0] is curve 1
  std::vector<int> idOfCurve_;
};

}  // namespace

ModelMesh meshDomain(const DomainModel& model, const AF2Algorithm& algorithm,
                     const DomainMeshingOptions& options) {
  checkDomain(model, options);
  ModelMesh mesh;
  withThreads(options.threads, [&] {
    DomainMeshingOptions own = options;
    own.threads = 0;                                // as many as the arena has
    own.size = std::min(own.size, model.diagonal);  // no element could be larger
    if (own.elementsAcross > 0) {
      // A first mesh shows what is narrow.
      own.elementsAcross = 0;
      DomainMeshingOptions first = own;
      first.faces.clear();
      first.optimize = false;
      first.order = 1;
      first.progress = {};
      first.observer = nullptr;
      addSources(narrowPlaces(DomainMesher(model, algorithm, first).mesh(), options.elementsAcross,
                              own.threads),
                 leastForLimits(options.size, options.minSize), own.sources);
    }
    mesh = DomainMesher(model, algorithm, own).mesh();
  });
  return mesh;
}

}  // namespace af2::geometry
