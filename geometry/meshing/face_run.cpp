#include "geometry/meshing/face_run.h"

#include <algorithm>
#include <map>
#include <memory>
#include <new>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/parallel.h"
#include "engine/base/stopwatch.h"
#include "engine/step/rule_scoring.h"
#include "geometry/base/free_memory.h"
#include "geometry/check/sound_faces.h"
#include "geometry/fill/face_filling.h"
#include "geometry/layers/missing_layers.h"
#include "geometry/mesh/inside_out.h"
#include "geometry/mesh/join_faces.h"
#include "geometry/mesh/second_order.h"
#include "geometry/meshing/check_options.h"
#include "geometry/meshing/congruent_faces.h"
#include "geometry/meshing/even_division.h"
#include "geometry/meshing/first_faces.h"
#include "geometry/meshing/progress_sum.h"
#include "geometry/meshing/spooled_faces.h"
#include "geometry/meshing/try_rounds.h"

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
    const CongruentFaces congruent(source_, algorithm_, options_, faces_);
    const auto give = [&](const FaceTry& from, std::vector<FaceTry>& others) {
      congruent.move(from, into.meshes[from.face], sizes.sizes, into.divided, others,
                     [&](const FaceTry& at, FaceMesh moved) {
                       if (isObserved(at.face))  // its observer is to see a front, too
                         meshed(at.face, sizes.sizes, at.limits, into.divided, {}, nullptr);
                       take(at.face, std::move(moved), into);
                       putAway(into.meshes[at.face], into.divided);
                     });
    };
    std::vector<TryGroup> groups =
        congruent.groupsOf(tries, meshedBefore(tries, into), into.divided);
    forEachInParallel(groups.size(), threads, [&](std::size_t g) {
      for (const std::size_t face : groups[g].meshed) give({face, {}}, groups[g].tries);
    });
    TryRounds rounds(std::move(groups));
    for (auto next = rounds.next(); !next.empty(); next = rounds.next())
      meshEach(next, sizes, threads, into, [&](std::size_t k) { give(next[k], rounds.others(k)); });
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
    forgetFormerMeshes(state.meshes);
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

  bool isObserved(std::size_t i) const {
    return options_.observer && options_.observer(faces_[i]) != nullptr;
  }

  /// The faces with meshes of their own that are not to be tried now.
  static std::vector<std::size_t> meshedBefore(std::span<const FaceTry> tries,
                                               const FaceMeshes& state) {
    std::vector<bool> isTried(state.meshes.size(), false);
    for (const FaceTry& next : tries) isTried[next.face] = true;
    std::vector<std::size_t> faces;
    for (std::size_t i = 0; i < state.meshes.size(); ++i)
      if (!isTried[i] && !state.waits(i) && state.meshes[i].report.congruentTo == 0)
        faces.push_back(i);
    return faces;
  }

  /// done  called once for each try, when its mesh is in `into`; from several threads at once
  template <class Done>
  void meshEach(std::span<const FaceTry> tries, const RequestedSizes& sizes, int threads,
                FaceMeshes& into, const Done& done) const {
    std::vector<double> work;
    for (const FaceTry& next : tries) work.push_back(progress_->work()[next.face]);
    const std::vector<std::size_t> order = largestFirst(work);
    const auto finish = [&](std::size_t k) {
      done(k);
      putAway(into.meshes[tries[k].face], into.divided);
    };
    if (!leader_)
      return forEachInParallel(order.size(), threads, [&](std::size_t place) {
        const FaceTry& next = tries[order[place]];
        mesh(next.face, sizes.sizes, next.limits, into);
        finish(order[place]);
      });
    leader_->meshAll(
        {into.divided, sizes.places}, tries, work,
        [&](const FaceTry& next, RegionCrew* pieces) {
          return meshed(next.face, sizes.sizes, next.limits, into.divided, progressOf(next.face),
                        pieces);
        },
        [&](std::size_t k, FaceMesh mesh) { take(tries[k].face, std::move(mesh), into); });
    // While meshes arrive, nothing that others keep can be fetched.
    forEachInParallel(order.size(), threads, [&](std::size_t place) { finish(order[place]); });
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
    FillOptions fill = fillOptionsOf(options_);
    fill.crew = pieces;
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

}  // namespace

MeasuredMesh meshOnce(FaceSource& source, const AF2Algorithm& algorithm,
                      const MeshingOptions& options) {
  return FaceRun(source, algorithm, options).mesh();
}

void followOnce(FaceSource& source, const AF2Algorithm& algorithm, const MeshingOptions& options,
                CrewFollower& crew) {
  FaceRun(source, algorithm, options).follow(crew);
}

}  // namespace af2::geometry
