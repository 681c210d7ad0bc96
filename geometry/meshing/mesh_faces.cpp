#include "geometry/meshing/mesh_faces.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/base/parallel.h"
#include "engine/base/place_text.h"
#include "engine/base/stopwatch.h"
#include "engine/step/rule_scoring.h"
#include "geometry/base/free_memory.h"
#include "geometry/check/sound_faces.h"
#include "geometry/fill/face_filling.h"
#include "geometry/layers/missing_layers.h"
#include "geometry/mesh/inside_out.h"
#include "geometry/mesh/join_faces.h"
#include "geometry/mesh/narrow_places.h"
#include "geometry/mesh/second_order.h"
#include "geometry/meshing/check_options.h"
#include "geometry/meshing/chord_rounds.h"
#include "geometry/meshing/even_division.h"
#include "geometry/meshing/face_crew.h"
#include "geometry/meshing/finer_faces.h"
#include "geometry/meshing/first_faces.h"
#include "geometry/meshing/progress_sum.h"
#include "geometry/meshing/spooled_faces.h"
#include "geometry/sizes/coarser_sizes.h"
#include "geometry/sizes/too_many.h"

namespace af2::geometry {

namespace {

std::vector<std::size_t> largestFirst(const std::vector<double>& work) {
  std::vector<std::size_t> order(work.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return work[a] > work[b]; });
  return order;
}

/// One run over the faces of a source. Faces are counted in the order of the request, from 0.
class FaceRun final : public RetriedModel {
 public:
  FaceRun(FaceSource& source, const AF2Algorithm& algorithm, const MeshingOptions& options)
      : source_(source),
        algorithm_(algorithm),
        options_(options),
        faces_(facesAskedFor(source, options)),
        spool_(spoolFor(options)),
        leader_(options.crew ? options.crew->leader() : nullptr) {}

  MeasuredMesh mesh() {
    const Stopwatch edgesWatch;
    if (leader_) leader_->beginRun(changeOf(options_));
    prepare();
    FaceMeshes state;
    state.divided = divide(source_.sizesByPosition(), {});
    const double edgeSeconds = edgesWatch.seconds();

    const Stopwatch facesWatch;
    meshFirst(state);
    retry(state);
    if (leader_) leader_->endRun();
    const double optimizeShare = shareOfOptimizing(state.meshes);
    const double faceSeconds = facesWatch.seconds();
    MeasuredMesh result = finished(state);
    StageSeconds& seconds = result.mesh.seconds;
    seconds.edges = edgeSeconds;
    seconds.optimize = optimizeShare * faceSeconds;
    seconds.surface = faceSeconds - seconds.optimize;
    return result;
  }

  /// Meshes what the leader of the crew tells.
  void follow(CrewFollower& crew) {
    prepare();
    while (const std::optional<FaceRound> round = crew.nextRound()) {
      const PositionSize sizes = refinedSizes(source_.sizesByPosition(), round->near,
                                              options_.sizes.growth, largestOf(options_.sizes));
      crew.help(
          [&](const FaceTry& next, RegionCrew* pieces) {
            return meshed(next.face, sizes, next.limits, round->divided, {}, pieces);
          },
          [&](FaceMesh& mesh) { putAway(mesh, round->divided); });
    }
  }

  const std::vector<std::vector<int>>& edgesOfFaces() const override { return edgesOfFaces_; }

  DividedEdges divide(const PositionSize& sizes, const CollapsedEdges& asPoints) const override {
    if (options_.evenLoops)
      return divideWithEvenLoops(source_, sizes, asPoints, options_.threads, options_.stop);
    return source_.divide(sizes, asPoints, {});
  }

  std::vector<CollapsedEdges> shortEdges(std::size_t i, const DividedEdges& divided,
                                         const std::vector<SizeSource>& places) const override {
    return source_.shortEdges(faces_[i], divided, places);
  }

  void mesh(std::size_t i, const PositionSize& sizes, const TryLimits& limits,
            FaceMeshes& into) const override {
    take(i, meshed(i, sizes, limits, into.divided, progressOf(i), nullptr), into);
  }

  /// The most work is begun first.
  void meshAll(std::span<const FaceTry> tries, const RequestedSizes& sizes, int threads,
               FaceMeshes& into) const override {
    std::vector<double> work;
    for (const FaceTry& next : tries) work.push_back(progress_->work()[next.face]);
    if (!leader_) {
      std::vector<FaceTry> sorted;
      for (const std::size_t k : largestFirst(work)) sorted.push_back(tries[k]);
      return forEachInParallel(sorted.size(), threads, [&](std::size_t k) {
        mesh(sorted[k].face, sizes.sizes, sorted[k].limits, into);
        putAway(into.meshes[sorted[k].face], into.divided);
      });
    }
    leader_->meshAll(
        {into.divided, sizes.places}, tries, work,
        [&](const FaceTry& next, RegionCrew* pieces) {
          return meshed(next.face, sizes.sizes, next.limits, into.divided, progressOf(next.face),
                        pieces);
        },
        [&](std::size_t k, FaceMesh mesh) {
          take(tries[k].face, std::move(mesh), into);
          putAway(into.meshes[tries[k].face], into.divided);
        });
  }

  void join(FaceMeshes& state) const override {
    JoinOptions join;
    join.threads = options_.threads;
    const std::map<int, double>& sizes = options_.sizes.edgeSizes;
    for (int edge = 1; edge <= static_cast<int>(state.divided.edges.size()); ++edge)
      if (const auto own = sizes.find(source_.idOfEdge(edge)); own != sizes.end())
        join.edgeSizes[edge] = bounded(options_.sizes, own->second);
    if (options_.order == 2)
      join.pointOnEdge = [&](int edge, double parameter) {
        return source_.pointOnEdge(edge, parameter);
      };
    join.spool = spool_;
    for (FaceMesh& mesh : state.meshes) putAway(mesh, state.divided);  // what remedies have changed
    state.joined = joinFaces(state.divided, state.meshes, join);
    const bool mayCross = source_.mayCross() && !options_.stop.stop_requested();
    state.faults =
        spool_ ? faultsOfSpooled(state.joined, evidenceOf(state.meshes), mayCross, options_.threads)
               : faultsOf(state.joined, mayCross, options_.threads);
  }

  std::vector<SizeSource> sizesInside(std::size_t i) const override {
    return source_.sizesInside(faces_[i]);
  }

  bool hasFaultInModel(std::size_t i) const override { return source_.hasFaultInModel(faces_[i]); }

  bool meetsOthers(std::size_t i, const std::vector<Crossing>& crossings) const override {
    return source_.meetsOthers(faces_[i], crossings);
  }

 private:
  void prepare() {
    source_.prepare(options_, faces_);
    for (const int face : faces_) edgesOfFaces_.push_back(source_.edgesOf(face));
    std::vector<double> work;
    for (const int face : faces_) work.push_back(source_.workOn(face));
    progress_.emplace(options_.progress, std::move(work));
  }

  ProgressCallback progressOf(std::size_t i) const {
    return [this, i](const Progress& p) { progress_->advance(i, p.elements); };
  }

  void take(std::size_t i, FaceMesh mesh, FaceMeshes& into) const {
    into.meshes[i] = std::move(mesh);
    progress_->finish(i, into.meshes[i].elements.size());
  }

  /// The first try at faces that may ask for shorter edges; the others wait for these.
  void meshFirst(FaceMeshes& state) const {
    state.meshes.resize(faces_.size());
    state.isWaiting.assign(faces_.size(), false);
    if (mostRetries() > 0) {
      state.isWaiting = smallFaces(progress_->work());
      state.isWaiting.flip();
    }
    std::vector<FaceTry> tries;
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (!state.waits(i)) tries.push_back({i, {}});
    meshAll(tries, {{}, source_.sizesByPosition()}, options_.threads, state);
  }

  int mostRetries() const {
    return options_.strictRules ? 0 : options_.mostRetries.value_or(RetryOptions().mostRounds);
  }

  void retry(FaceMeshes& state) const {
    RetryOptions retries{source_.sizesByPosition(), largestOf(options_.sizes),
                         options_.sizes.growth, options_.threads, options_.stop};
    retries.share = source_.retryShare();
    retries.mayTilt = source_.mayTilt();
    retries.mostRounds = mostRetries();
    const RuleSet& rules = algorithm_.rules();
    retries.mayMakeReflex = RuleScoring(rules.definition()).allowsReflexAt(rules.maxLevel());
    retryPoorFaces(*this, retries, state);
  }

  FaceMesh meshed(std::size_t i, const PositionSize& sizes, const TryLimits& limits,
                  const DividedEdges& divided, const ProgressCallback& progress,
                  RegionCrew* pieces) const {
    const Stopwatch watch;
    const int face = faces_[i];
    FaceMesh mesh;
    mesh.report = source_.reportOf(face);
    if (options_.stop.stop_requested()) {
      mesh.report.status = FaceStatus::Cancelled;
      return mesh;
    }
    FillOptions fill{
        options_.chart, options_.optimize, options_.quads, options_.strictRules, options_.stop, {},
        pieces};
    if (options_.observer) fill.observer = [&] { return options_.observer(face); };
    try {
      source_.fill(face, {sizes, limits, divided, algorithm_, fill, options_.order == 2, progress},
                   mesh);
    } catch (const std::bad_alloc&) {
      if (options_.crew) throw;  // the other processes may have enough
      failFor("there is not enough memory; ask for a larger size", mesh);
    } catch (const std::exception& failure) {
      failFor(failure.what(), mesh);
    }
    mesh.report.seconds = watch.seconds();
    return mesh;
  }

  static std::shared_ptr<SpoolFile> spoolFor(const MeshingOptions& options) {
    if (options.spool.when != SpoolRequest::When::Always) return nullptr;
    if (options.spool.where == SpoolRequest::Where::Memory) return std::make_shared<SpoolFile>();
    return std::make_shared<SpoolFile>(options.spool.folder);
  }

  /// A face that is done, if faces are put on disk.
  void putAway(FaceMesh& mesh, const DividedEdges& divided) const {
    constexpr std::size_t kMany = 100'000;
    if (!spool_) return;
    const bool isLarge = mesh.elements.size() > kMany;
    spoolFace(mesh, divided, source_.mayCross(), spool_);
    if (isLarge) returnFreedMemory();  // it is in pieces that do not fit the next face
  }

  MeasuredMesh finished(FaceMeshes& state) const {
    const MiddlesByFace middles = takeMiddles(state.meshes);
    std::vector<FaceMesh>().swap(state.meshes);  // two meshes need much memory
    ModelMesh mesh = std::move(state.joined);
    for (const AF2Rule& rule : algorithm_.rules().rules()) mesh.ruleNames.push_back(rule.name());
    for (const std::string_view name : kWithoutRuleNames)
      if (name != kLayerName || !options_.layers.empty()) mesh.ruleNames.emplace_back(name);
    mesh.groups = source_.groups();
    mesh.findings = keepSoundFaces(mesh, state.faults);
    const bool isBounded = options_.sizes.chords.areGiven() && !options_.stop.stop_requested();
    EdgeCurves curves;
    if (isBounded)
      curves = edgeCurves(mesh, state.divided, [&](int edge, double parameter) {
        return source_.pointOnEdge(edge, parameter);
      });
    for (EdgeSegment& segment : mesh.segments) segment.edge = source_.idOfEdge(segment.edge);
    source_.complete(state.faults, mesh);
    tellOfMissingLayers(options_.layers, mesh);
    if (isInsideOut(mesh)) mesh.notes.emplace_back(kInsideOut);
    if (options_.sizes.size < options_.sizes.minSize)
      mesh.notes.push_back(raisedSizeNote(options_.sizes));
    MeasuredMesh result{std::move(mesh), {}, {}};
    if (isBounded) result = measured(source_, options_, std::move(result.mesh), std::move(curves));
    if (options_.order == 2) makeSecondOrder(result.mesh, middlesOf(result.mesh, middles));
    return result;
  }

  FaceSource& source_;
  const AF2Algorithm& algorithm_;
  const MeshingOptions& options_;
  std::vector<int> faces_;
  std::shared_ptr<SpoolFile> spool_;  ///< null: faces stay in memory
  CrewLeader* leader_;                ///< null: no other process meshes faces for this one
  std::vector<std::vector<int>> edgesOfFaces_;
  mutable std::optional<ProgressSum> progress_;  ///< of the first mesh of each face
};

/// Places narrower than the elements across them get sizes of their own. Narrow places are between
/// any two faces, so that all are meshed for this.
void addNarrowPlaces(FaceSource& source, const AF2Algorithm& algorithm, MeshingOptions& options) {
  const double across = std::exchange(options.sizes.elementsAcross, 0);
  MeshingOptions first = options;
  first.faces.clear();
  first.optimize = false;
  first.order = 1;
  first.evenLoops = false;  // narrow places are the same with the option and without
  if (options.progress)
    first.progress = [&options](const ModelProgress& now) {
      ModelProgress none;  // of the mesh that is asked for
      none.faces = now.faces;
      none.workTotal = now.workTotal;
      options.progress(none);
    };
  first.observer = {};
  first.sizes.chords = {};
  first.layers.clear();  // they are not narrow places of the model
  const ModelMesh coarse = FaceRun(source, algorithm, first).mesh().mesh;
  addSources(narrowPlaces(coarse, across, options.threads),
             leastForLimits(options.sizes.size, options.sizes.minSize), options.sizes.sources);
}

/// Does what the leader of the crew decides, as often as it meshes the faces.
ModelMesh follow(CrewFollower& crew, FaceSource& source, const AF2Algorithm& algorithm,
                 const MeshingOptions& options) {
  while (const std::optional<RunChange> change = crew.nextRun()) {
    const MeshingOptions own = withChange(options, *change);
    FaceRun(source, algorithm, own).follow(crew);
  }
  return crew.reports();
}

/// Finds narrow places first, keeps to the bounds on the distance from the model, and takes smaller
/// sizes where faces fail. The seconds are those of all meshes that were made.
ModelMesh meshWithin(FaceSource& source, const AF2Algorithm& algorithm, MeshingOptions options) {
  if (options.sizes.elementsAcross > 0) addNarrowPlaces(source, algorithm, options);
  StageSeconds spent;
  const auto make = [&](const MeshingOptions& asked) {
    MeasuredMesh made = FaceRun(source, algorithm, asked).mesh();
    spent.edges += made.mesh.seconds.edges;
    spent.surface += made.mesh.seconds.surface;
    spent.optimize += made.mesh.seconds.optimize;
    return made;
  };
  const auto within = [&](const MeshingOptions& asked) {
    if (!asked.sizes.chords.areGiven()) return make(asked).mesh;
    MeasuredMesh measured = meshWithinChords(asked, make);
    if (asked.fewest) thinWithinChords(source, asked, measured);
    return std::move(measured.mesh);
  };
  ModelMesh mesh = meshFinerWhereFailed(source, std::move(options), within);
  mesh.seconds = spent;
  return mesh;
}

/// With sizes that are larger than those that are asked for, if these need too much memory.
ModelMesh meshWithinMemory(FaceSource& source, const AF2Algorithm& algorithm,
                           MeshingOptions options) {
  constexpr double kMost = 1e6;  // then something else is wrong
  bool isTooLarge = false;
  for (double factor = 1;;) {
    try {
      ModelMesh mesh = meshWithin(source, algorithm, options);
      if (factor > 1)
        mesh.notes.push_back("the sizes that were asked for need too much memory: all are " +
                             af2::textOf(factor, 4) + " times as large");
      if (isTooLarge)
        mesh.notes.emplace_back(
            "the mesh needs more memory than there is: its faces were put on "
            "disk one by one");
      return mesh;
    } catch (const TooManyElements& error) {
      if (options.spool.when == SpoolRequest::When::IfNeeded && !options.crew &&
          error.fitSpooled() && whyNotSpooled(options).empty()) {
        options.spool.when = SpoolRequest::When::Always;
        isTooLarge = true;
        continue;
      }
      if (!options.coarsen || options.crew || factor > kMost) throw;
      factor *= error.factor();
      options.sizes = timesAsLarge(std::move(options.sizes), error.factor());
    }
  }
}

}  // namespace

ModelMesh meshFaces(FaceSource& source, const AF2Algorithm& algorithm,
                    const MeshingOptions& options) {
  checkOptions(source, options);
  ModelMesh mesh;
  // One arena for all stages: a thread that has to change arenas comes late to the next stage.
  withThreads(options.threads, [&] {
    MeshingOptions own = optionsFor(source, options);
    own.threads = 0;  // as many as the arena has
    if (own.crew && own.crew->follower()) {
      mesh = follow(*own.crew->follower(), source, algorithm, own);
      return;
    }
    mesh = meshWithinMemory(source, algorithm, own);
    if (own.crew && own.crew->leader()) own.crew->leader()->endModel(mesh);
  });
  return mesh;
}

}  // namespace af2::geometry
