#include "engine/run/cut_strips.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <mutex>
#include <numeric>
#include <ranges>
#include <span>
#include <utility>

namespace af2 {
namespace {

/// How many rings of elements along a cut are optimised.
constexpr std::uint8_t kRings = 4;

constexpr std::uint8_t kFar = 255;
using Rings = std::vector<std::uint8_t>;

/// Numbers the vertices of the elements by their distance, in rings, from those numbered 0; up to
/// kRings.
template <class Elements>
void spread(const Mesh& mesh, const Elements& elements, Rings& ring) {
  for (std::uint8_t r = 0; r < kRings; ++r) {
    for (const std::size_t e : elements) {
      const auto corners = mesh.elements[e].vertices();
      if (std::ranges::none_of(corners, [&](VertexId v) { return ring[v.value] == r; })) continue;
      for (const VertexId v : corners)
        if (ring[v.value] == kFar) ring[v.value] = static_cast<std::uint8_t>(r + 1);
    }
  }
}

/// A part of a mesh with its own numbering: fixed vertices first.
struct Strip {
  Mesh mesh;
  std::size_t fixedCount = 0;
  std::vector<std::size_t> elements;  ///< of the whole mesh, by element of the strip
  std::vector<VertexId> vertices;     ///< likewise
};

/// By vertex of the whole mesh: its id in a strip; none: not in the strip.
using LocalIds = std::vector<VertexId>;

/// local  none for all vertices of the mesh; returned filled
template <class IsFree>
Strip take(const Mesh& mesh, std::vector<std::size_t> elements, const IsFree& isFree,
           LocalIds& local) {
  Strip strip;
  for (const std::size_t e : elements)
    for (const VertexId v : mesh.elements[e].vertices()) {
      VertexId& id = local[v.value];
      if (!id.isNone()) continue;
      id = v;  // placeholder: its number is not known yet
      strip.vertices.push_back(v);
    }
  std::ranges::sort(strip.vertices);
  const auto free =
      std::ranges::stable_partition(strip.vertices, [&](VertexId v) { return !isFree(v); });
  strip.fixedCount = strip.vertices.size() - free.size();
  for (std::size_t i = 0; i < strip.vertices.size(); ++i) {
    local[strip.vertices[i].value] = VertexId(i);
    strip.mesh.vertices.push_back(mesh.vertices[strip.vertices[i].value]);
  }
  for (const std::size_t e : elements) {
    Element element = mesh.elements[e];
    for (VertexId& v : element.corners)
      if (!v.isNone()) v = local[v.value];
    strip.mesh.elements.push_back(element);
    strip.mesh.origins.push_back(mesh.origins[e]);
  }
  strip.elements = std::move(elements);
  return strip;
}

bool isDead(const Element& element) { return element.corners[0].isNone(); }

/// The strip may have more or fewer elements and free vertices than were taken. Places that it no
/// longer needs are left dead and unused, new ones are appended. Returns the places of new
/// elements.
std::vector<std::size_t> putBack(Strip& strip, Mesh& mesh) {
  std::vector<std::size_t> appended;
  while (strip.vertices.size() < strip.mesh.vertices.size()) {
    strip.vertices.emplace_back(mesh.vertices.size());
    mesh.vertices.emplace_back();
  }
  while (strip.elements.size() < strip.mesh.elements.size()) {
    appended.push_back(mesh.elements.size());
    strip.elements.push_back(mesh.elements.size());
    mesh.elements.emplace_back();
    mesh.origins.emplace_back();
  }
  for (std::size_t v = strip.fixedCount; v < strip.mesh.vertices.size(); ++v)
    mesh.vertices[strip.vertices[v].value] = strip.mesh.vertices[v];
  for (std::size_t e = 0; e < strip.mesh.elements.size(); ++e) {
    Element element = strip.mesh.elements[e];
    for (VertexId& v : element.corners)
      if (!v.isNone()) v = strip.vertices[v.value];
    mesh.elements[strip.elements[e]] = element;
    mesh.origins[strip.elements[e]] = strip.mesh.origins[e];
  }
  for (std::size_t e = strip.mesh.elements.size(); e < strip.elements.size(); ++e)
    mesh.elements[strip.elements[e]] = {};
  return appended;
}

/// Removes dead elements, and vertices from `fixedCount` on that no element uses.
void squeeze(Mesh& mesh, std::size_t fixedCount) {
  std::vector<VertexId> renumbered(mesh.vertices.size());
  std::size_t elements = 0, vertices = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (isDead(mesh.elements[e])) continue;
    for (const VertexId v : mesh.elements[e].vertices()) renumbered[v.value] = v;
    mesh.origins[elements] = mesh.origins[e];
    mesh.elements[elements++] = mesh.elements[e];
  }
  mesh.elements.resize(elements);
  mesh.origins.resize(elements);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (v >= fixedCount && renumbered[v].isNone()) continue;
    renumbered[v] = VertexId(vertices);
    mesh.vertices[vertices++] = mesh.vertices[v];
  }
  mesh.vertices.resize(vertices);
  for (Element& element : mesh.elements)
    for (VertexId& v : element.corners)
      if (!v.isNone()) v = renumbered[v.value];
}

using Edges = std::vector<std::pair<VertexId, VertexId>>;

/// The edges whose two ends are both in a strip, in the strip's numbering.
Edges localEdges(const LocalIds& local, const Edges& edges) {
  Edges inside;
  for (const auto& [from, to] : edges) {
    const std::pair here(local[from.value], local[to.value]);
    if (!here.first.isNone() && !here.second.isNone()) inside.push_back(here);
  }
  return inside;
}

/// The edges at which a strip ends, and the region's boundary edges along it.
MeshBoundary boundaryOf(const Strip& strip, const LocalIds& local, const Edges& ofRegion) {
  Edges edges, rim;
  for (const Element& element : strip.mesh.elements) {
    const auto corners = element.vertices();
    for (std::size_t i = 0; i < corners.size(); ++i)
      edges.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
  }
  std::ranges::sort(edges);
  for (const auto& [from, to] : edges)
    if (!std::ranges::binary_search(edges, std::pair(to, from))) rim.emplace_back(from, to);
  for (const auto& edge : localEdges(local, ofRegion))
    if (std::ranges::binary_search(edges, edge)) rim.push_back(edge);
  std::ranges::sort(rim);
  rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
  return {strip.fixedCount, std::move(rim)};
}

/// What is known of the vertices while a strip is taken. Each strip is small and there are many, so
/// this is used again: made anew for each, it would take as long as there are strips times
/// vertices.
struct Scratch {
  Rings ring;      ///< kFar for all vertices but those of the strip in work
  LocalIds local;  ///< likewise none
};

/// As many as there are threads that take strips.
class ScratchPool {
 public:
  std::unique_ptr<Scratch> take(std::size_t vertices) {
    std::unique_ptr<Scratch> scratch;
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        scratch = std::move(idle_.back());
        idle_.pop_back();
      }
    }
    if (!scratch) scratch = std::make_unique<Scratch>();
    scratch->ring.resize(vertices, kFar);
    scratch->local.resize(vertices);
    return scratch;
  }

  void giveBack(std::unique_ptr<Scratch> scratch) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(scratch));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Scratch>> idle_;
};

/// All elements along cuts as one mesh, from which the strip along each cut is taken.
class Strips {
 public:
  Strips(Mesh& mesh, const FrontInput& input, const SplitRegion& split, const AlongCuts& along,
         const StripTools& tools)
      : split_(split), along_(along), tools_(tools), mesh_(mesh), firstCut_(input.vertexCount) {
    Rings ring(mesh.vertices.size(), kFar);
    std::fill_n(ring.begin() + static_cast<std::ptrdiff_t>(firstCut_), split.cutVertices.size(),
                std::uint8_t{0});
    spread(mesh, along.elements, ring);
    local_.resize(mesh.vertices.size());
    all_ = take(
        mesh, along.elements,
        [&](VertexId v) { return v.value >= firstCut_ && ring[v.value] < kRings; }, local_);
    local_.resize(firstCut_ + split.cutVertices.size());  // others are not asked for
    local_.shrink_to_fit();
    boundary_ = localEdges(local_, af2::boundaryOf(input).edges);
    for (std::size_t p = 0; p + 1 < along.start.size(); ++p) {
      std::vector<std::size_t>& elements = elementsOf_.emplace_back();
      elements.resize(along.start[p + 1] - along.start[p]);
      std::iota(elements.begin(), elements.end(), along.start[p]);
    }
  }

  void optimize() {
    int deepest = 0;
    for (const RegionCut& cut : split_.cuts) deepest = std::max(deepest, cut.depth);
    for (int depth = deepest; depth >= 0; --depth) optimizeAt(depth);
    squeeze(all_.mesh, all_.fixedCount);
    const bool isSmaller = all_.mesh.elements.size() < all_.elements.size() ||
                           all_.mesh.vertices.size() < all_.vertices.size();
    putBack(all_, mesh_);
    if (isSmaller) squeeze(mesh_, firstCut_);
  }

 private:
  /// Cuts of the same depth change different elements and vertices, so they can run in parallel.
  void optimizeAt(int depth) {
    std::vector<const RegionCut*> cuts;
    for (const RegionCut& cut : split_.cuts)
      if (cut.depth == depth) cuts.push_back(&cut);
    std::vector<Strip> strips(cuts.size());
    tools_.forEach(cuts.size(), [&](std::size_t i) {
      std::unique_ptr<Scratch> scratch = scratches_.take(all_.mesh.vertices.size());
      strips[i] = optimizedStrip(*cuts[i], *scratch);
      scratches_.giveBack(std::move(scratch));
    });
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      // From now on the pieces of this part are used together only: any of them will do.
      std::ranges::copy(putBack(strips[i], all_.mesh),
                        std::back_inserter(elementsOf_[cuts[i]->pieces.begin]));
    }
  }

  Strip optimizedStrip(const RegionCut& cut, Scratch& scratch) const {
    const std::vector<std::size_t> part = elementsIn(cut.pieces);
    Rings& ring = scratch.ring;
    for (std::size_t v = cut.own.begin; v < cut.own.end; ++v) ring[localCut(v).value] = 0;
    spread(all_.mesh, part, ring);
    const auto isFree = [&](VertexId v) {
      return v.value >= all_.fixedCount && ring[v.value] < kRings && !isOnOther(v, cut);
    };
    std::vector<std::size_t> elements;
    for (const std::size_t e : part)
      if (std::ranges::any_of(all_.mesh.elements[e].vertices(), isFree)) elements.push_back(e);
    Strip strip = take(all_.mesh, std::move(elements), isFree, scratch.local);
    MeshBoundary boundary = boundaryOf(strip, scratch.local, boundary_);
    for (const VertexId v : strip.vertices) scratch.local[v.value] = {};
    for (const std::size_t e : part)
      for (const VertexId v : all_.mesh.elements[e].vertices()) ring[v.value] = kFar;
    for (std::size_t v = cut.own.begin; v < cut.own.end; ++v) ring[localCut(v).value] = kFar;
    OptimizeOptions how;
    how.stop = tools_.stop;
    tools_.finish(strip.mesh, boundary, how);
    return strip;
  }

  std::vector<std::size_t> elementsIn(IndexRange pieces) const {
    std::vector<std::size_t> elements;
    for (std::size_t p = pieces.begin; p < pieces.end; ++p)
      std::ranges::copy_if(elementsOf_[p], std::back_inserter(elements),
                           [&](std::size_t e) { return !isDead(all_.mesh.elements[e]); });
    return elements;
  }

  VertexId localCut(std::size_t cutVertex) const { return local_[firstCut_ + cutVertex]; }

  /// Whether a vertex lies on a cut that bounds the part of the region that `cut` divides.
  bool isOnOther(VertexId v, const RegionCut& cut) const {
    if (v.value >= all_.vertices.size()) return false;  // a new vertex
    const std::size_t id = all_.vertices[v.value].value;
    if (id < firstCut_ || id >= firstCut_ + split_.cutVertices.size()) return false;
    return id < firstCut_ + cut.own.begin || id >= firstCut_ + cut.within.end;
  }

  const SplitRegion& split_;
  const AlongCuts& along_;
  const StripTools& tools_;
  Mesh& mesh_;
  std::size_t firstCut_;  ///< the first vertex of a cut
  Strip all_;
  LocalIds local_;  ///< in `all_`, of the vertices on the boundary of the region and on cuts
  ScratchPool scratches_;
  std::vector<std::vector<std::size_t>> elementsOf_;  ///< by piece, some dead; of `all_`
  Edges boundary_;  ///< boundary of the region, in the numbering of `all_`
};

}  // namespace

std::vector<std::uint32_t> elementsAlongCuts(const Mesh& mesh, const RegionPiece& piece,
                                             std::size_t given) {
  Rings ring(mesh.vertices.size(), kFar);
  for (std::size_t v = 0; v < piece.vertices.size(); ++v)
    if (piece.vertices[v].value >= given) ring[v] = 0;
  spread(mesh, std::views::iota(std::size_t{0}, mesh.elements.size()), ring);
  std::vector<std::uint32_t> found;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (std::ranges::any_of(mesh.elements[e].vertices(),
                            [&](VertexId v) { return ring[v.value] < kRings; }))
      found.push_back(static_cast<std::uint32_t>(e));
  return found;
}

void optimizeAlongCuts(Mesh& mesh, const FrontInput& input, const SplitRegion& split,
                       const AlongCuts& along, const StripTools& tools) {
  Strips(mesh, input, split, along, tools).optimize();
}

}  // namespace af2
