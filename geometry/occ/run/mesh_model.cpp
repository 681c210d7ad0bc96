#include "geometry/occ/run/mesh_model.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "engine/base/error.h"
#include "engine/base/stopwatch.h"
#include "geometry/base/parallel.h"
#include "geometry/check/sound_faces.h"
#include "geometry/mesh/inside_out.h"
#include "geometry/mesh/join_faces.h"
#include "geometry/mesh/narrow_places.h"
#include "geometry/mesh/second_order.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/edges/edge_division.h"
#include "geometry/occ/edges/short_edges.h"
#include "geometry/occ/faces/face_area.h"
#include "geometry/occ/faces/face_mesher.h"
#include "geometry/occ/faces/faces_on_faces.h"
#include "geometry/occ/faces/meeting_faces.h"
#include "geometry/occ/run/creased_shape.h"
#include "geometry/occ/run/progress_sum.h"
#include "geometry/occ/sizes/sizing.h"
#include "geometry/occ/surfaces/face_surface.h"
#include "geometry/retry/retries.h"
#include "geometry/sizes/too_many.h"

namespace af2::geometry {

namespace {

std::vector<int> facesAskedFor(const Model& model, const ModelMeshingOptions& options) {
  std::vector<int> faces = options.faces;
  if (faces.empty()) {
    faces.resize(static_cast<std::size_t>(model.faceCount()));
    std::iota(faces.begin(), faces.end(), 1);
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  for (const int face : faces)
    if (face < 1 || face > model.faceCount())
      throw InputError("face " + std::to_string(face) + ": the model has faces 1 to " +
                       std::to_string(model.faceCount()));
  return faces;
}

std::string toldOfLost(const std::vector<std::string>& faces) {
  constexpr std::size_t kMostNamed = 10;
  std::string text = faces.size() == 1 ? "a face" : std::to_string(faces.size()) + " faces";
  text += " of the file could not be read, so the mesh lacks " +
          std::string(faces.size() == 1 ? "it: " : "them: ");
  for (std::size_t i = 0; i < std::min(faces.size(), kMostNamed); ++i)
    text += (i > 0 ? ", " : "") + faces[i];
  if (faces.size() > kMostNamed)
    text += " and " + std::to_string(faces.size() - kMostNamed) + " more";
  return text + "; export the model again";
}

class ModelMesher final : public RetriedModel {
 public:
  ModelMesher(const Model& model, const AF2Algorithm& algorithm, ModelMeshingOptions options)
      : model_(model), algorithm_(algorithm), options_(std::move(options)) {}

  ModelMesh mesh() {
    faces_ = facesAskedFor(model_, options_);
    refuseBlurred(farthestVertex(), model_.shape().diagonal, options_.sizes.size);
    shape_ =
        withCreases(model_.sharedShape(), faces_, options_.sizes, options_.threads, options_.stop);
    findEdgesOfFaces();
    onFaces_ = onFacesAmong(faces_);
    areas_ = areasOf(faces_);
    leaveOutAreas(faces_);
    work_ = expectedWork();
    const Stopwatch edgesWatch;
    isFineInside_ = isFineInside(options_.sizes);
    uneven_ = unevenFaces(*shape_, options_.sizes, options_.threads, options_.stop);
    options_.sizes =
        spreadSizes(*shape_, std::move(options_.sizes), uneven_, options_.threads, options_.stop);
    expectMoreOnUneven();
    expectByPosition();
    sampled_ = sampleEdges(*shape_, options_.sizes, options_.threads, options_.stop);
    FaceMeshes state;
    state.divided = divide(options_.sizes.function, {});
    const double edgeSeconds = edgesWatch.seconds();

    const Stopwatch facesWatch;
    meshFaces(state);
    retryPoorFaces(*this,
                   {options_.sizes.function, largestAsked(options_.sizes), options_.sizes.growth,
                    options_.threads, options_.stop},
                   state);
    const double optimizeShare = shareOfOptimizing(state.meshes);
    const MiddlesByFace middles = takeMiddles(state.meshes);
    std::vector<FaceMesh>().swap(state.meshes);
    ModelMesh mesh = std::move(state.joined);
    for (const AF2Rule& rule : algorithm_.rules().rules()) mesh.ruleNames.push_back(rule.name());
    mesh.ruleNames.push_back("closing");  // what closes a stuck front
    mesh.groups = model_.groups();
    mesh.unit = model_.unit();
    mesh.fileUnit = model_.fileUnit();
    mesh.notes = model_.notes();
    mesh.healing = model_.healing();
    mesh.seconds.edges = edgeSeconds;
    const double surfaceSeconds = facesWatch.seconds();
    mesh.seconds.optimize = optimizeShare * surfaceSeconds;
    mesh.seconds.surface = surfaceSeconds - mesh.seconds.optimize;
    mesh.findings = keepSoundFaces(mesh, state.faults);
    tellOfMeetingFaces(*shape_, state.faults.crossings, options_.sizes.size, mesh.faces);
    if (faces_.size() == static_cast<std::size_t>(model_.faceCount()) &&
        !model_.lostFaces().empty())
      mesh.findings.push_back(toldOfLost(model_.lostFaces()));
    if (isInsideOut(mesh)) mesh.notes.emplace_back(kInsideOut);
    if (options_.order == 2) makeSecondOrder(mesh, middlesOf(mesh, middles));
    return mesh;
  }

 private:
  const std::vector<std::vector<int>>& edgesOfFaces() const override { return edgesOfFaces_; }

  /// The largest coordinate of a vertex.
  double farthestVertex() const {
    const ModelShape& shape = model_.shape();
    double farthest = 0;
    for (int id = 1; id <= shape.vertices.Extent(); ++id) {
      const Point3 p = toPoint(BRep_Tool::Pnt(shape.vertex(id)));
      farthest = std::max({farthest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    return farthest;
  }

  void findEdgesOfFaces() {
    const ModelShape& shape = *shape_;
    for (const int face : faces_) {
      std::vector<int>& edges = edgesOfFaces_.emplace_back();
      for (const EdgeUse& use : shape.edgesOfFaces[static_cast<std::size_t>(face) - 1])
        edges.push_back(use.id);
      std::ranges::sort(edges);
      edges.erase(std::ranges::unique(edges).begin(), edges.end());
    }
  }

  ModelMeshingOptions withSizes(const PositionSize& sizes) const {
    ModelMeshingOptions options = options_;
    options.sizes.function = sizes;
    return options;
  }

  DividedEdges divide(const PositionSize& sizes, const EdgesAsPoints& asPoints) const override {
    return divideEdges(*shape_, sampled_, withSizes(sizes).sizes, options_.threads, options_.stop,
                       options_.edgePoints, asPoints);
  }

  std::vector<EdgesAsPoints> shortEdges(std::size_t i, const DividedEdges& divided,
                                        const std::vector<SizeSource>& places) const override {
    return shortEdgesNear(*shape_, faces_[i], divided, places,
                          wantedOnFace(options_.sizes, faces_[i]));
  }

  void mesh(std::size_t i, const PositionSize& sizes, const TryLimits& limits,
            FaceMeshes& into) const override {
    meshOne(i, withSizes(sizes), into, {}, limits);
  }

  std::vector<SizeSource> sizesInside(std::size_t i) const override {
    if (options_.sizes.elementsPerTurn > 0) return {};  // they are spread already
    return geometry::sizesInside(*shape_, faces_[i], options_.sizes);
  }

  static double largestAsked(const ModelSizes& sizes) {
    double largest = sizes.size;
    for (const auto& [face, size] : sizes.faceSizes) largest = std::max(largest, size);
    for (const auto& [edge, size] : sizes.edgeSizes) largest = std::max(largest, size);
    return largest;
  }

  void join(FaceMeshes& state) const override {
    JoinOptions join;
    join.threads = options_.threads;
    for (const auto& [edge, size] : options_.sizes.edgeSizes)
      join.edgeSizes[edge] = bounded(options_.sizes, size);
    if (options_.order == 2)
      join.pointOnEdge = [&](int edge, double parameter) {
        return toPoint(BRepAdaptor_Curve(shape_->edge(edge)).Value(parameter));
      };
    state.joined = joinFaces(state.divided, state.meshes, join);
    state.faults = faultsOf(state.joined, !options_.stop.stop_requested(), options_.threads);
  }

  void meshFaces(FaceMeshes& state) {
    ProgressSum progress(options_, work_);
    state.meshes.resize(faces_.size());
    const std::vector<std::size_t> order = largestFirst(work_);
    forEachInParallel(faces_.size(), options_.threads, [&](std::size_t k) {
      const std::size_t i = order[k];
      meshOne(i, options_, state, [&](const Progress& p) { progress.advance(i, p.elements); },
              {std::numeric_limits<std::size_t>::max()});
      progress.finish(i, state.meshes[i].elements.size());
    });
  }

  void meshOne(std::size_t i, const ModelMeshingOptions& options, FaceMeshes& state,
               ProgressCallback progress, const TryLimits& limits) const {
    const FaceMeshingContext context{
        *shape_,       algorithm_,          options,       state.divided,
        onFaces_,      std::move(progress), isFineInside_, limits.mostCandidates,
        limits.mayLean};
    state.meshes[i] = options.stop.stop_requested()
                          ? cancelled(faces_[i])
                          : meshFace(context, faces_[i], areas_[i], work_[i]);
  }

  /// Whether sizes inside faces may be much smaller than along their boundaries.
  static bool isFineInside(const ModelSizes& sizes) {
    return sizes.function || !sizes.sources.isEmpty();
  }

  /// Faces that lie on another one which is to be meshed, too, or is to be meshed alone.
  std::vector<FaceOnFace> onFacesAmong(const std::vector<int>& faces) const {
    std::vector<FaceOnFace> found = facesOnFaces(*shape_, options_.threads);
    std::erase_if(found, [&](const FaceOnFace& lying) {
      return !std::ranges::binary_search(faces, lying.under);
    });
    return found;
  }

  void leaveOutAreas(const std::vector<int>& faces) {
    const auto areaAt = [&](int face) -> double* {
      const auto found = std::ranges::lower_bound(faces, face);
      if (found == faces.end() || *found != face) return nullptr;
      return &areas_[static_cast<std::size_t>(found - faces.begin())];
    };
    for (const FaceOnFace& lying : onFaces_) {
      double* area = areaAt(lying.under);
      if (area && !lying.isDouble()) *area -= areaOf(*shape_, lying.face);
      if (double* own = areaAt(lying.face)) *own = 0;
    }
  }

  FaceMesh cancelled(int face) const {
    FaceMesh mesh;
    mesh.report.id = face;
    mesh.report.name = model_.faceName(face);
    mesh.report.surfaceType = model_.surfaceType(face);
    mesh.report.status = FaceStatus::Cancelled;
    return mesh;
  }

  std::vector<double> areasOf(const std::vector<int>& faces) const {
    std::vector<double> areas(faces.size(), 0);
    forEachInParallel(faces.size(), options_.threads, [&](std::size_t i) {
      if (!options_.stop.stop_requested()) areas[i] = areaOf(*shape_, faces[i]);
    });
    return areas;
  }

  /// How many elements a face takes; 0 if nobody knows.
  ///
  /// samples  along each parameter, where sizes differ from place to place; 0: as few as will do
  double expectedOn(std::size_t i, int samples) const {
    if (!(areas_[i] > 0) || options_.stop.stop_requested()) return 0;
    try {
      return expectedElements(options_.sizes, faces_[i], shape_->surface(faces_[i]), areas_[i],
                              samples);
    } catch (const GeometryError&) {  // reported when the face is meshed
    } catch (const Standard_Failure&) {
    }
    return 0;
  }

  std::vector<double> expectedWork() const {
    std::vector<double> work(faces_.size());
    forEachInParallel(work.size(), options_.threads,
                      [&](std::size_t i) { work[i] = 1 + expectedOn(i, 0); });
    refuseTooMany(std::accumulate(work.begin(), work.end(), 0.0));
    return work;
  }

  /// Once it is known how sizes spread there.
  void expectMoreOnUneven() {
    forEachInParallel(faces_.size(), options_.threads, [&](std::size_t i) {
      if (std::ranges::binary_search(uneven_, faces_[i]))
        work_[i] = 1 + expectedOn(i, kSamplesWhereUneven);
    });
    refuseTooMany(std::accumulate(work_.begin(), work_.end(), 0.0));
  }

  /// Points, boxes, functions and turns may want small sizes anywhere. What turns want is found by
  /// a few samples as well as what faces want without them; points, boxes and functions may hide.
  void expectByPosition() {
    constexpr int kSamples = 8;
    if (!isFineInside_ && options_.sizes.elementsPerTurn == 0) return;
    std::vector<double> elements(faces_.size());
    forEachInParallel(elements.size(), options_.threads, [&](std::size_t i) {
      elements[i] = expectedOn(i, kSamples);
      if (!isFineInside_) work_[i] = std::max(work_[i], 1 + elements[i]);
    });
    refuseTooMany(std::accumulate(elements.begin(), elements.end(), 0.0));
  }

  static std::vector<std::size_t> largestFirst(const std::vector<double>& work) {
    std::vector<std::size_t> order(work.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return work[a] > work[b]; });
    return order;
  }

  static constexpr int kSamplesWhereUneven = 32;

  const Model& model_;
  std::shared_ptr<const ModelShape> shape_;  // with edges along its creases
  const AF2Algorithm& algorithm_;
  ModelMeshingOptions options_;
  std::vector<int> faces_;                      // that were asked for
  std::vector<std::vector<int>> edgesOfFaces_;  // by face that was asked for
  std::vector<double> areas_, work_;            // by face that was asked for
  std::vector<EdgeSamples> sampled_;            // by edge
  std::vector<int> uneven_;
  std::vector<FaceOnFace> onFaces_;
  bool isFineInside_ = false;
};

ModelMesh meshOnceOrTwice(const Model& model, const AF2Algorithm& algorithm,
                          const ModelMeshingOptions& options) {
  if (options.sizes.elementsAcross == 0) return ModelMesher(model, algorithm, options).mesh();
  ModelMeshingOptions finer = options;
  finer.sizes.elementsAcross = 0;
  ModelMeshingOptions first = finer;
  first.faces.clear();  // narrow places are between any two
  first.optimize = false;
  first.progress = {};
  first.observer = {};
  const ModelMesh coarse = ModelMesher(model, algorithm, std::move(first)).mesh();
  addSources(narrowPlaces(coarse, options.sizes.elementsAcross, options.threads),
             leastForLimits(options.sizes.size, options.sizes.minSize), finer.sizes.sources);
  return ModelMesher(model, algorithm, std::move(finer)).mesh();
}

}  // namespace

ModelMesh meshModel(const Model& model, const AF2Algorithm& algorithm,
                    const ModelMeshingOptions& options) {
  checkSizes(options.sizes, model);
  if (options.order != 1 && options.order != 2) throw InputError("elements can have order 1 or 2");
  for (const auto& [edge, points] : options.edgePoints)
    if (edge < 1 || edge > model.edgeCount())
      throw InputError("points for edge " + std::to_string(edge) + ": the model has edges 1 to " +
                       std::to_string(model.edgeCount()));
  // One arena for all stages: a thread that has to change arenas comes late to the next stage.
  ModelMeshingOptions inArena = options;
  inArena.threads = 0;
  inArena.sizes = withinModel(options.sizes, model);
  ModelMesh mesh;
  withThreads(options.threads, [&] { mesh = meshOnceOrTwice(model, algorithm, inArena); });
  return mesh;
}

}  // namespace af2::geometry
