#include "engine/run/mesh_region.h"

#include <algorithm>
#include <mutex>

#include "engine/base/parallel.h"
#include "engine/base/stopwatch.h"
#include "engine/mesh/mesh_check.h"
#include "engine/optimize/finish_mesh.h"
#include "engine/run/cut_strips.h"
#include "engine/run/mesh_piece.h"

namespace af2 {
namespace {

/// Sums the progress of all pieces; forwards one call at a time.
class SharedProgress {
 public:
  SharedProgress(const ProgressCallback& callback, std::size_t pieces)
      : callback_(callback), last_(pieces) {}

  ProgressCallback ofPiece(std::size_t piece) {
    if (!callback_) return {};
    return [this, piece](const Progress& progress) {
      const std::lock_guard lock(mutex_);
      sum_.elements += progress.elements - last_[piece].elements;
      sum_.frontEdges += progress.frontEdges - last_[piece].frontEdges;
      sum_.candidates += progress.candidates - last_[piece].candidates;
      sum_.area += progress.area - last_[piece].area;
      last_[piece] = progress;
      callback_(sum_);
    };
  }
  /// Tells that the work goes on, from any thread.
  std::function<void()> again() {
    if (!callback_) return {};
    return [this] {
      const std::lock_guard lock(mutex_);
      callback_(sum_);
    };
  }

 private:
  const ProgressCallback& callback_;
  std::mutex mutex_;
  Progress sum_;
  std::vector<Progress> last_;
};

/// Joins the meshes of the pieces, in the numbering of the whole region and in the order of the
/// pieces. Each piece is copied and freed as soon as all pieces before it have been, so that few
/// pieces are in memory beside the joined mesh.
class PieceJoiner {
 public:
  PieceJoiner(const RegionTask& task, const SplitRegion& split, std::vector<RegionMesh>& pieces)
      : task_(task),
        split_(split),
        pieces_(pieces),
        along_(pieces.size()),
        isDone_(pieces.size(), false) {
    joined_.mesh.vertices.resize(task.input.vertexCount);
    joined_.mesh.vertices.insert(joined_.mesh.vertices.end(), split.cutVertices.begin(),
                                 split.cutVertices.end());
    onCuts_ = joined_.mesh.vertices.size();
    for (const RegionPiece& piece : split.pieces) expected_ += piece.expectedElements;
  }

  /// Called from several threads, once for each finished piece.
  void finish(std::size_t piece) {
    if (task_.optimize)
      along_[piece] = elementsAlongCuts(pieces_[piece].result.mesh, split_.pieces[piece],
                                        task_.input.vertexCount);
    const std::lock_guard lock(mutex_);
    isDone_[piece] = true;
    for (; next_ < pieces_.size() && isDone_[next_]; ++next_) take(next_);
  }

  /// Called once, when all pieces are finished.
  MeshingResult result() { return std::move(joined_); }
  const AlongCuts& alongCuts() const { return alongCuts_; }

 private:
  void take(std::size_t p) {
    const RegionPiece& piece = split_.pieces[p];
    MeshingResult& result = pieces_[p].result;
    const Mesh& mesh = result.mesh;
    Mesh& joined = joined_.mesh;
    const std::size_t inner = joined.vertices.size(), given = piece.vertices.size();
    const std::size_t firstElement = joined.elements.size();
    expectedSoFar_ += piece.expectedElements;
    makeRoom(joined.vertices, mesh.vertices.size() - given, onCuts_);
    makeRoom(joined.elements, mesh.elements.size(), 0);
    makeRoom(joined.origins, mesh.origins.size(), 0);
    for (std::size_t v = 0; v < given; ++v)
      joined.vertices[piece.vertices[v].value] = mesh.vertices[v];
    joined.vertices.insert(joined.vertices.end(),
                           mesh.vertices.begin() + static_cast<std::ptrdiff_t>(given),
                           mesh.vertices.end());
    for (Element element : mesh.elements) {
      for (VertexId& v : element.corners)
        if (!v.isNone())
          v = v.value < given ? piece.vertices[v.value] : VertexId(inner + v.value - given);
      joined.elements.push_back(element);
    }
    joined.origins.insert(joined.origins.end(), mesh.origins.begin(), mesh.origins.end());
    for (const std::uint32_t e : along_[p]) alongCuts_.elements.push_back(firstElement + e);
    alongCuts_.start.push_back(alongCuts_.elements.size());
    joined_.steps += result.steps;
    joined_.failedSteps += result.failedSteps;
    joined_.candidates += result.candidates;
    joined_.acts += result.acts;
    result.mesh = {};
  }

  /// Reserves memory for the pieces to come, estimated from the pieces so far. Growing step by step
  /// would hold the mesh twice each time.
  ///
  /// ofNoPiece  how many at the start come from no piece
  template <class T>
  void makeRoom(std::vector<T>& all, std::size_t more, std::size_t ofNoPiece) const {
    constexpr double kMargin = 1.1;
    const std::size_t needed = all.size() + more;
    if (needed <= all.capacity()) return;
    const double share = expectedSoFar_ > 0 ? expected_ / expectedSoFar_ : 1;
    const double ofPieces = kMargin * share * static_cast<double>(needed - ofNoPiece);
    all.reserve(ofNoPiece + std::max(needed - ofNoPiece, static_cast<std::size_t>(ofPieces)));
  }

  const RegionTask& task_;
  const SplitRegion& split_;
  std::vector<RegionMesh>& pieces_;
  std::vector<std::vector<std::uint32_t>> along_;  ///< by piece: its elements along cuts
  std::vector<bool> isDone_;
  std::size_t next_ = 0;  ///< the first piece that has not been copied yet
  double expected_ = 0, expectedSoFar_ = 0;
  std::size_t onCuts_ = 0;  ///< vertices that are there before any piece: boundary and cuts
  std::mutex mutex_;
  MeshingResult joined_;
  AlongCuts alongCuts_{{}, {0}};
};

/// goesOn  must be callable from several threads
StripTools stripToolsOf(const AF2Algorithm& algorithm, const RegionTask& task,
                        const FrontOptions& options, const std::function<void()>& goesOn) {
  FinishObserver* observer = options.observer ? options.observer->finishing() : nullptr;
  const auto finish = [&algorithm, &task, observer, goesOn](
                          Mesh& mesh, const MeshBoundary& boundary, OptimizeOptions how) {
    const PieceTools tools = task.makeTools();
    how.observer = observer;
    how.goesOn = goesOn;
    // Only with quadrilaterals is a mesh more regular where it may be numbered anew.
    how.renumber = algorithm.rules().makesQuads();
    how.quads = task.quads;
    finishMesh(mesh, boundary, {algorithm.rules(), *tools.charts, *tools.size}, how);
  };
  const auto forEach = [&task, observer](std::size_t count, const auto& work) {
    if (!observer) return forEachInParallel(count, task.threads, work);
    // One after the other: the observer must receive changes in order.
    for (std::size_t i = 0; i < count; ++i) work(i);
  };
  return {finish, forEach, options.stop};
}

/// Meshes the pieces of a region, and joins them.
class PieceMesher {
 public:
  PieceMesher(const AF2Algorithm& algorithm, const RegionTask& task, const SplitRegion& split,
              const FrontOptions& options)
      : algorithm_(algorithm),
        task_(task),
        split_(split),
        options_(options),
        pieces_(split.pieces.size()),
        joiner_(task, split, pieces_),
        progress_(options.progress, pieces_.size()) {}

  /// Whether the pieces are this process's.
  bool meshAll() {
    const auto finish = [&](std::size_t p) {
      pieces_[p] = mesh(p);
      joiner_.finish(p);
    };
    if (options_.observer)
      // One after the other: the observer must receive steps in order.
      for (std::size_t p = 0; p < pieces_.size(); ++p) finish(p);
    else if (task_.crew)
      return meshWithCrew();
    else  // begun in order, so that pieces that wait for those before them to be joined are few
      forEachInParallel(pieces_.size(), task_.threads, finish);
    return true;
  }

  const std::vector<RegionMesh>& pieces() const { return pieces_; }
  PieceJoiner& joiner() { return joiner_; }
  std::function<void()> goesOn() { return progress_.again(); }

 private:
  RegionMesh mesh(std::size_t p) {
    FrontOptions own = options_;
    Progress last;
    if (const ProgressCallback report = progress_.ofPiece(p))
      own.progress = [&last, report](const Progress& now) {
        last = now;
        report(now);
      };
    own.expectedElements = split_.pieces[p].expectedElements;
    RegionMesh piece = meshPiece(algorithm_, task_, split_.pieces[p].input, own);
    piece.progress = last;
    return piece;
  }

  bool meshWithCrew() {
    std::vector<double> work;
    for (const RegionPiece& piece : split_.pieces) work.push_back(piece.expectedElements);
    return task_.crew->meshPieces(
        work, [&](std::size_t p) { return mesh(p); },
        [&](std::size_t p, RegionMesh piece) {
          // Limits hold for all pieces together, wherever they were meshed.
          if (const ProgressCallback report = progress_.ofPiece(p)) report(piece.progress);
          pieces_[p] = std::move(piece);
          joiner_.finish(p);
        });
  }

  const AF2Algorithm& algorithm_;
  const RegionTask& task_;
  const SplitRegion& split_;
  const FrontOptions& options_;
  std::vector<RegionMesh> pieces_;
  PieceJoiner joiner_;
  SharedProgress progress_;
};

}  // namespace

RegionMesh meshRegion(const AF2Algorithm& algorithm, const RegionTask& given,
                      const FrontOptions& options) {
  const Stopwatch watch;
  RegionTask task = given;
  task.optimize = given.optimize && finishesMeshes(algorithm.rules());
  const RuleSet& rules = algorithm.rules();
  task.split.evenPieces =
      given.split.evenPieces || rules.makesQuads() || rules.definition().parity == Parity::Even;
  SplitRegion split;
  if (task.surface)
    split = splitRegion(task.input, *task.surface, *task.makeTools().size, task.split);
  if (split.pieces.size() <= 1) {
    FrontOptions own = options;
    if (!split.pieces.empty()) own.expectedElements = split.pieces[0].expectedElements;
    return meshPiece(algorithm, task, task.input, own);
  }

  RegionMesh whole;
  whole.seconds = watch.seconds();
  PieceMesher mesher(algorithm, task, split, options);
  bool isCancelled = !mesher.meshAll();
  bool isSound = true;
  for (const RegionMesh& piece : mesher.pieces()) {
    isSound = isSound && piece.result.outcome == Outcome::Complete && piece.fault.empty();
    isCancelled = isCancelled || piece.result.outcome == Outcome::Cancelled;
    whole.seconds += piece.seconds;
    whole.optimizeSeconds += piece.optimizeSeconds;
  }
  // If a piece fails because of a badly placed cut, the whole region is meshed without cuts.
  if (!isSound && !isCancelled) {
    mesher.joiner().result();  // frees its memory
    return meshPiece(algorithm, task, task.input, options);
  }

  whole.result = mesher.joiner().result();
  if (isCancelled) {
    whole.result.outcome = Outcome::Cancelled;
    return whole;
  }
  const Stopwatch optimizing;
  if (task.optimize)
    optimizeAlongCuts(whole.result.mesh, task.input, split, mesher.joiner().alongCuts(),
                      stripToolsOf(algorithm, task, options, mesher.goesOn()));
  whole.optimizeSeconds += optimizing.seconds();
  whole.seconds += optimizing.seconds();
  return whole;
}

}  // namespace af2
