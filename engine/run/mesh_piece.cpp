#include "engine/run/mesh_piece.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "engine/base/stopwatch.h"
#include "engine/base/work_watch.h"
#include "engine/mesh/mesh_check.h"
#include "engine/optimize/finish_mesh.h"
#include "engine/optimize/turn_round.h"

namespace af2 {
namespace {

/// Of one piece: the progress of its front is told again while what follows goes on.
class PieceProgress {
 public:
  explicit PieceProgress(const ProgressCallback& report) : report_(report) {}

  /// For a front that begins when others have ended, whose candidates count, too.
  ProgressCallback ofFront() {
    if (!report_) return {};
    return [this, before = last_.candidates](Progress now) {
      now.candidates += before;
      last_ = now;
      report_(now);
    };
  }
  std::function<void()> again() const {
    if (!report_) return {};
    return [this] { report_(last_); };
  }

 private:
  const ProgressCallback& report_;
  Progress last_;
};

/// Fills one piece by a front, and a second time if the first mesh is not sound.
class PieceFronts {
 public:
  PieceFronts(const AF2Algorithm& algorithm, const PieceTools& tools, const FrontInput& input,
              const MeshBoundary& boundary, const FrontOptions& options)
      : algorithm_(algorithm),
        tools_(tools),
        input_(input),
        boundary_(boundary),
        options_(options),
        progress_(options_.progress) {}

  std::function<void()> goesOn() const { return progress_.again(); }

  /// The front with its reflex elements turned round; where that is impossible, without such
  /// elements, unless that leaves more of the front open.
  MeshingResult sound() {
    MeshingResult result = run(options_);
    if (result.outcome == Outcome::Cancelled || !hasTurnedElements(result.mesh)) return result;
    const bool isComplete = result.outcome == Outcome::Complete;
    if (isComplete && turnElementsRound(result.mesh, boundary_, *tools_.charts,
                                        WorkWatch(options_.stop, goesOn())) == 0)
      return result;
    FrontOptions again = options_;
    again.observer = nullptr;  // it has seen the first one
    again.acceptReflex = false;
    if (!isComplete) again.stallCandidates = std::min(again.stallCandidates, result.candidates / 4);
    MeshingResult second = run(again);
    if (isComplete || second.outcome != Outcome::Stuck) return second;
    return second.stuck.size() < result.stuck.size() ? std::move(second) : std::move(result);
  }

  /// Without the observer, which has seen the same front.
  MeshingResult anew() {
    options_.observer = nullptr;
    return sound();
  }

 private:
  MeshingResult run(FrontOptions options) {
    options.progress = progress_.ofFront();
    return algorithm_.execute(*tools_.charts, input_, *tools_.size, options);
  }

  const AF2Algorithm& algorithm_;
  const PieceTools& tools_;
  const FrontInput& input_;
  const MeshBoundary& boundary_;
  FrontOptions options_;
  PieceProgress progress_;
};

}  // namespace

RegionMesh meshPiece(const AF2Algorithm& algorithm, const RegionTask& task, const FrontInput& input,
                     const FrontOptions& options) {
  const Stopwatch watch;
  RegionMesh piece;
  const MeshBoundary boundary = boundaryOf(input);
  const PieceTools tools = task.makeTools();
  PieceFronts fronts(algorithm, tools, input, boundary, options);
  piece.result = fronts.sound();
  if (piece.result.outcome == Outcome::Complete) piece.fault = faultOf(piece.result.mesh, boundary);
  if (piece.result.outcome == Outcome::Complete && piece.fault.empty() && task.optimize) {
    const Stopwatch optimizing;
    OptimizeOptions how;
    how.stop = options.stop;
    how.goesOn = fronts.goesOn();
    how.keepOriginal = false;
    how.quads = task.quads;
    if (options.observer) how.observer = options.observer->finishing();
    const FinishTask finish{algorithm.rules(), *tools.charts, *tools.size};
    if (!finishMesh(piece.result.mesh, boundary, finish, how).isSound) piece.result = fronts.anew();
    piece.optimizeSeconds = optimizing.seconds();
  }
  piece.seconds = watch.seconds();
  return piece;
}

}  // namespace af2
