#include "engine/optimize/optimize.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/mesh/element_shape.h"
#include "engine/mesh/mesh_check.h"
#include "engine/mesh/mesh_topology.h"
#include "engine/mesh/triangle_grades.h"
#include "engine/optimize/corner_mending.h"
#include "engine/optimize/edge_collapse.h"
#include "engine/optimize/edge_swap.h"
#include "engine/optimize/patch_filling.h"
#include "engine/optimize/quad_division.h"
#include "engine/optimize/quad_search.h"
#include "engine/optimize/quad_tidying.h"
#include "engine/optimize/smoothing.h"
#include "engine/optimize/triangle_walk.h"

namespace af2 {
namespace {

/// An element more distorted than this is poor: below 0.87 of the ideal shape.
constexpr double kPoorDistortion = 1.15;

bool isPoor(const Mesh& mesh, const Element& element) {
  const auto at = [&](std::size_t i) -> const Point3& {
    return mesh.vertices[element.corners[i].value].position;
  };
  if (element.size() == 3) {
    const Point3 p = at(1) - at(0), q = at(2) - at(0);
    return !isPlainlyBelow(kPoorDistortion, p, q, cross(p, q)) &&
           cornerDistortion(at(0), at(1), at(2), true) > kPoorDistortion;
  }
  for (std::size_t i = 0; i < 4; ++i)
    if (cornerDistortion(at(i), at((i + 1) % 4), at((i + 3) % 4), false) > kPoorDistortion)
      return true;
  return false;
}

/// Elements that may be poor, and the inner vertices of these elements.
class PoorElements {
 public:
  explicit PoorElements(MeshTopology& topology) : topology_(topology) {
    for (std::size_t e = 0; e < topology.mesh().elements.size(); ++e)
      if (!isKnownGood(topology, e) && !topology.isDead(e)) look(e);
    sortOut();
  }

  /// In order, without repetition.
  const std::vector<VertexId>& vertices() const { return vertices_; }

  /// Updates the poor elements after some of the vertices have moved.
  void renew() {
    const std::vector<VertexId> before = std::move(vertices_);
    vertices_.clear();
    for (const VertexId v : before)
      topology_.forEachCornerOf(v, [&](Corner c) { look(c.element()); });
    sortOut();
  }

 private:
  void look(std::size_t e) {
    const Element& element = topology_.mesh().elements[e];
    if (isGood(topology_, e) || !isPoor(topology_.mesh(), element)) return;
    for (const VertexId v : element.vertices())
      if (!topology_.isFixed(v)) vertices_.push_back(v);
  }
  void sortOut() {
    std::ranges::sort(vertices_);
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  }

  MeshTopology& topology_;
  std::vector<VertexId> vertices_;
};

/// Smooths the poor elements that remain after the general smoothing, each individually.
std::size_t mendPoorElements(MeshTopology& topology, VertexSmoother& smoother,
                             const WorkWatch& watch) {
  constexpr int kRounds = 3, kSweeps = 2;
  PoorElements poor(topology);
  std::size_t moves = 0;
  for (int round = 0; round < kRounds && !watch.mustStop(); ++round) {
    std::size_t moved = 0;
    for (int sweep = 0; sweep < kSweeps; ++sweep) moved += smoother.mend(poor.vertices());
    if (moved == 0) break;
    moves += moved;
    poor.renew();
  }
  return moves;
}

/// One way after another to make a mesh with quadrilaterals more regular.
class QuadCleaner {
 public:
  QuadCleaner(MeshTopology& topology, const AF2LocalTransformMaker& maker,
              const OptimizeOptions& options, ActRecorder* recorder, const WorkWatch& watch)
      : editor_(topology, maker, topology.anglesAtFixed(), recorder),
        depth_(options.quads.usedDepth()),
        watch_(watch) {}

  std::size_t joinTriangles() { return walkTriangles(editor_, watch_); }
  std::size_t clean() { return clean(std::min(depth_, QuadCleanUp::kUsualDepth), kGoodFilling); }
  /// What takes much longer, from the result of what does not, so that it never does worse.
  std::size_t cleanThoroughly() {
    return depth_ <= QuadCleanUp::kUsualDepth ? 0 : clean(depth_, kBestFilling);
  }

 private:
  std::size_t clean(int depth, const FillingEffort& effort) {
    if (depth == 0) return 0;
    const std::size_t found = searchQuads(editor_, depth, watch_);
    const std::size_t moved = moveInward(editor_, depth, watch_);
    const std::size_t filled = fillPatches(editor_, effort, watch_);
    return found + filled + moved + divideFlatQuads(editor_, watch_);
  }

  PatchEditor editor_;
  int depth_;
  const WorkWatch& watch_;
};

/// Returns the number of changes.
std::size_t cleanUp(MeshTopology& topology, const AF2LocalTransformMaker& maker,
                    const OptimizeOptions& options, ActRecorder* recorder, const WorkWatch& watch,
                    bool isLastRound) {
  if (options.quads.usedDepth() == 0 && !options.quads.onlyQuads) return 0;
  QuadCleaner cleaner(topology, maker, options, recorder, watch);
  std::size_t changes = options.quads.onlyQuads ? cleaner.joinTriangles() : 0;
  changes += cleaner.clean();
  if (isLastRound) changes += cleaner.cleanThoroughly();
  return changes;
}

/// Everything except the final check of the mesh.
OptimizeReport improve(Mesh& mesh, const MeshBoundary& boundary,
                       const AF2LocalTransformMaker& maker, const OptimizeOptions& options) {
  OptimizeReport report;
  const WorkWatch watch(options.stop, options.goesOn);
  MeshTopology topology(mesh, boundary);
  std::optional<ActRecorder> observed;
  if (options.observer) observed.emplace(*options.observer, mesh, distortionIn(mesh));
  ActRecorder* recorder = observed ? &*observed : nullptr;
  VertexSmoother smoother(topology, mesh, maker, recorder);
  const std::vector<double> angles = topology.anglesAtFixed();
  const std::vector<std::uint8_t> wanted = wantedValences(angles);
  const bool hasQuads =
      std::ranges::any_of(mesh.elements, &Element::isQuad) ||
      (options.closingRule &&
       std::ranges::count(mesh.origins, *options.closingRule, &ElementOrigin::rule) > 0);
  const int rounds = options.rounds + (hasQuads ? 1 : 0);
  // Rounds with quadrilaterals smooth twice, and no vertex goes to sleep early in them.
  const bool hasOneLess = hasQuads && options.smoothingSweeps > 1;
  const int sweeps = options.smoothingSweeps - (hasOneLess ? 1 : 0);
  const auto smooth = [&] {
    smoother.wake(topology.takeChanged());
    for (int sweep = 0; sweep < sweeps; ++sweep)
      if (!watch.mustStop()) report.moves += smoother.sweep(watch);
  };
  for (int round = 0; round < rounds && !watch.mustStop(); ++round) {
    if (hasQuads && options.renumber) {
      smooth();
      report.replacements +=
          tidyQuads(topology, angles, options.closingRule, recorder,
                    options.quads.onlyQuads ? MayAddTriangles::No : MayAddTriangles::Yes, watch);
      report.replacements +=
          cleanUp(topology, maker, options, recorder, watch, round + 1 == rounds);
    }
    report.swaps += swapSides(topology, SwapGoal::Valence, wanted, recorder, watch);
    if (options.renumber) report.collapses += collapseEdges(topology, recorder, watch);
    smooth();
    report.swaps += swapSides(topology, SwapGoal::Shape, wanted, recorder, watch);
  }
  smooth();
  report.moves += mendPoorElements(topology, smoother, watch);
  // What has moved may be better with another side.
  if (const std::size_t swaps = swapSides(topology, SwapGoal::Shape, wanted, recorder, watch)) {
    report.swaps += swaps;
    smooth();
    report.moves += mendPoorElements(topology, smoother, watch);
  }
  if (hasQuads) report.moves += mendCorners(topology, mesh, maker, recorder, watch);
  topology.compact();
  return report;
}

}  // namespace

std::size_t joinTriangles(Mesh& mesh, const MeshBoundary& boundary,
                          const AF2LocalTransformMaker& maker, const std::stop_token& stop,
                          const std::function<void()>& goesOn) {
  if (std::ranges::all_of(mesh.elements, &Element::isQuad)) return 0;
  const Mesh before = mesh;
  MeshTopology topology(mesh, boundary);
  PatchEditor editor(topology, maker, topology.anglesAtFixed());
  const std::size_t pairs = walkTriangles(editor, WorkWatch(stop, goesOn));
  topology.compact();
  if (pairs > 0 && checkMesh(mesh, boundary).empty()) return pairs;
  mesh = before;
  return 0;
}

OptimizeReport optimizeMesh(Mesh& mesh, const MeshBoundary& boundary,
                            const AF2LocalTransformMaker& maker, const OptimizeOptions& options) {
  std::optional<Mesh> before;
  if (options.keepOriginal) before = mesh;
  if (options.observer) options.observer->finishBegun(mesh);
  OptimizeReport report = improve(mesh, boundary, maker, options);
  report.isSound = checkMesh(mesh, boundary).empty();
  if (options.observer) options.observer->finishEnded(mesh, report.isSound);
  if (report.isSound || !before) return report;
  mesh = std::move(*before);
  return {};
}

}  // namespace af2
