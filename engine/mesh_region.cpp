#include "engine/mesh_region.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>

#include "engine/mesh_check.h"
#include "engine/optimize.h"
#include "engine/stopwatch.h"

namespace af2 {
namespace {

/// How many rings of elements along a cut are optimised once the pieces are joined.
constexpr int kRingsAlongCuts = 4;

/// Adds up what the pieces report; forwards it one call at a time.
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
      last_[piece] = progress;
      callback_(sum_);
    };
  }

 private:
  const ProgressCallback& callback_;
  std::mutex mutex_;
  Progress sum_;
  std::vector<Progress> last_;
};

RegionMesh meshPiece(const AF2Algorithm& algorithm, const RegionTask& task, const FrontInput& input,
                     const MeshingOptions& options) {
  const Stopwatch watch;
  RegionMesh piece;
  const MeshBoundary boundary = boundaryOf(input);
  const PieceTools tools = task.makeTools();
  piece.result = algorithm.execute(*tools.charts, input, *tools.size, options);
  if (piece.result.outcome == Outcome::Complete) piece.fault = faultOf(piece.result.mesh, boundary);
  if (piece.result.outcome == Outcome::Complete && piece.fault.empty() && task.optimize) {
    const Stopwatch optimizing;
    OptimizeOptions how;
    how.stop = options.stop;
    optimizeMesh(piece.result.mesh, boundary, *tools.charts, how);
    piece.optimizeSeconds = optimizing.seconds();
  }
  piece.seconds = watch.seconds();
  return piece;
}

/// Meshes of all pieces in the numbering of the whole region.
MeshingResult join(const FrontInput& input, const SplitRegion& split,
                   std::vector<RegionMesh>& pieces) {
  MeshingResult joined;
  std::size_t vertices = input.vertexCount + split.cutVertices.size(), elements = 0;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    vertices += pieces[p].result.mesh.vertices.size() - split.pieces[p].vertices.size();
    elements += pieces[p].result.mesh.elements.size();
  }
  // Else growing would hold the mesh twice, beside the pieces that are still there.
  joined.mesh.vertices.reserve(vertices);
  joined.mesh.elements.reserve(elements);
  joined.mesh.rule.reserve(elements);
  joined.mesh.vertices.resize(input.vertexCount);
  joined.mesh.vertices.insert(joined.mesh.vertices.end(), split.cutVertices.begin(),
                              split.cutVertices.end());
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const RegionPiece& piece = split.pieces[p];
    const Mesh& mesh = pieces[p].result.mesh;
    const std::size_t inner = joined.mesh.vertices.size();
    const std::size_t given = piece.vertices.size();
    const auto idOf = [&](VertexId v) {
      return v.value < given ? piece.vertices[v.value] : VertexId(inner + v.value - given);
    };
    for (std::size_t v = 0; v < given; ++v)
      joined.mesh.vertices[piece.vertices[v].value] = mesh.vertices[v];
    joined.mesh.vertices.insert(joined.mesh.vertices.end(),
                                mesh.vertices.begin() + static_cast<std::ptrdiff_t>(given),
                                mesh.vertices.end());
    for (Element element : mesh.elements) {
      for (VertexId& v : element.corners)
        if (!v.isNone()) v = idOf(v);
      joined.mesh.elements.push_back(element);
    }
    joined.mesh.rule.insert(joined.mesh.rule.end(), mesh.rule.begin(), mesh.rule.end());
    joined.steps += pieces[p].result.steps;
    joined.failedSteps += pieces[p].result.failedSteps;
    pieces[p].result.mesh = {};
  }
  return joined;
}

/// The part of a mesh along the cuts, numbered on its own: fixed vertices first.
struct Strip {
  Mesh mesh;
  MeshBoundary boundary;
  std::vector<std::size_t> elements;  ///< of the whole mesh, by element of the strip
  std::vector<VertexId> vertices;     ///< likewise
};

std::vector<std::uint8_t> ringsFromCuts(const Mesh& mesh, std::size_t firstCut, std::size_t cuts) {
  constexpr std::uint8_t kFar = 255;
  std::vector<std::uint8_t> ring(mesh.vertices.size(), kFar);
  std::fill_n(ring.begin() + static_cast<std::ptrdiff_t>(firstCut), cuts, std::uint8_t{0});
  for (std::uint8_t r = 0; r < kRingsAlongCuts; ++r) {
    for (const Element& element : mesh.elements) {
      const auto corners = element.vertices();
      if (std::none_of(corners.begin(), corners.end(),
                       [&](VertexId v) { return ring[v.value] == r; }))
        continue;
      for (VertexId v : corners)
        if (ring[v.value] == kFar) ring[v.value] = static_cast<std::uint8_t>(r + 1);
    }
  }
  return ring;
}

/// The boundary edges of the region that run along the strip, and the edges at which it ends.
std::vector<std::pair<VertexId, VertexId>> rimOf(const Strip& strip, const FrontInput& input,
                                                 const std::vector<VertexId>& local,
                                                 const std::vector<bool>& isUsed) {
  using Edge = std::pair<VertexId, VertexId>;
  std::vector<Edge> edges, rim;
  for (const Element& element : strip.mesh.elements) {
    const auto corners = element.vertices();
    for (std::size_t i = 0; i < corners.size(); ++i)
      edges.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
  }
  std::sort(edges.begin(), edges.end());
  for (const Edge& e : edges)
    if (!std::binary_search(edges.begin(), edges.end(), Edge{e.second, e.first})) rim.push_back(e);
  for (const Edge& e : boundaryOf(input).edges) {
    if (!isUsed[e.first.value] || !isUsed[e.second.value]) continue;
    const Edge edge{local[e.first.value], local[e.second.value]};
    if (std::binary_search(edges.begin(), edges.end(), edge)) rim.push_back(edge);
  }
  std::sort(rim.begin(), rim.end());
  rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
  return rim;
}

Strip stripAlongCuts(const Mesh& mesh, const FrontInput& input, std::size_t cuts) {
  const std::vector<std::uint8_t> ring = ringsFromCuts(mesh, input.vertexCount, cuts);
  const auto isFree = [&](std::size_t v) {
    return v >= input.vertexCount && ring[v] < kRingsAlongCuts;
  };
  Strip strip;
  std::vector<VertexId> local(mesh.vertices.size());
  std::vector<bool> isUsed(mesh.vertices.size(), false);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto corners = mesh.elements[e].vertices();
    if (std::none_of(corners.begin(), corners.end(), [&](VertexId v) { return isFree(v.value); }))
      continue;
    strip.elements.push_back(e);
    for (VertexId v : corners) isUsed[v.value] = true;
  }
  for (const bool free : {false, true}) {
    for (std::size_t v = 0; v < isUsed.size(); ++v) {
      if (!isUsed[v] || isFree(v) != free) continue;
      local[v] = VertexId(strip.vertices.size());
      strip.vertices.push_back(VertexId(v));
      strip.mesh.vertices.push_back(mesh.vertices[v]);
    }
    if (!free) strip.boundary.fixedCount = strip.vertices.size();
  }
  for (std::size_t e : strip.elements) {
    Element element = mesh.elements[e];
    for (VertexId& v : element.corners)
      if (!v.isNone()) v = local[v.value];
    strip.mesh.elements.push_back(element);
    strip.mesh.rule.push_back(mesh.rule[e]);
  }
  strip.boundary.edges = rimOf(strip, input, local, isUsed);
  return strip;
}

void optimizeAlongCuts(Mesh& mesh, const RegionTask& task, std::size_t cuts, std::stop_token stop) {
  Strip strip = stripAlongCuts(mesh, task.input, cuts);
  OptimizeOptions how;
  how.collapse = false;  // so that vertices and elements keep their numbers
  how.stop = std::move(stop);
  optimizeMesh(strip.mesh, strip.boundary, *task.makeTools().charts, how);
  for (std::size_t v = strip.boundary.fixedCount; v < strip.vertices.size(); ++v)
    mesh.vertices[strip.vertices[v].value] = strip.mesh.vertices[v];
  for (std::size_t e = 0; e < strip.elements.size(); ++e) {
    Element element = strip.mesh.elements[e];
    for (VertexId& v : element.corners)
      if (!v.isNone()) v = strip.vertices[v.value];
    mesh.elements[strip.elements[e]] = element;
  }
}

std::vector<RegionMesh> meshPieces(const AF2Algorithm& algorithm, const RegionTask& task,
                                   const SplitRegion& split, const MeshingOptions& options) {
  std::vector<RegionMesh> pieces(split.pieces.size());
  SharedProgress progress(options.progress, pieces.size());
  const auto mesh = [&](std::size_t p) {
    MeshingOptions own = options;
    own.progress = progress.ofPiece(p);
    pieces[p] = meshPiece(algorithm, task, split.pieces[p].input, own);
  };
  if (options.observer) {
    for (std::size_t p = 0; p < pieces.size(); ++p) mesh(p);  // it hears one step after the other
  } else {
    const auto meshAll = [&] {
      tbb::parallel_for(std::size_t{0}, pieces.size(), mesh, tbb::simple_partitioner());
    };
    if (task.threads > 0)
      tbb::task_arena(task.threads).execute(meshAll);
    else
      meshAll();
  }
  return pieces;
}

}  // namespace

RegionMesh meshRegion(const AF2Algorithm& algorithm, const RegionTask& task,
                      const MeshingOptions& options) {
  const Stopwatch watch;
  SplitRegion split;
  if (task.surface)
    split = splitRegion(task.input, *task.surface, *task.makeTools().size, task.split);
  if (split.pieces.size() <= 1) return meshPiece(algorithm, task, task.input, options);

  RegionMesh whole;
  whole.seconds = watch.seconds();
  std::vector<RegionMesh> pieces = meshPieces(algorithm, task, split, options);
  bool isSound = true, isCancelled = false;
  for (const RegionMesh& piece : pieces) {
    isSound = isSound && piece.result.outcome == Outcome::Complete && piece.fault.empty();
    isCancelled = isCancelled || piece.result.outcome == Outcome::Cancelled;
    whole.seconds += piece.seconds;
    whole.optimizeSeconds += piece.optimizeSeconds;
  }
  // A cut in an unlucky place must not cost the region.
  if (!isSound && !isCancelled) return meshPiece(algorithm, task, task.input, options);

  whole.result = join(task.input, split, pieces);
  if (isCancelled) {
    whole.result.outcome = Outcome::Cancelled;
    return whole;
  }
  const Stopwatch optimizing;
  if (task.optimize)
    optimizeAlongCuts(whole.result.mesh, task, split.cutVertices.size(), options.stop);
  whole.optimizeSeconds += optimizing.seconds();
  whole.seconds += optimizing.seconds();
  return whole;
}

}  // namespace af2
