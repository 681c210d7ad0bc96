#include "engine/optimize/patch_filling.h"

#include <algorithm>
#include <set>

#include "engine/optimize/ideal_angles.h"
#include "engine/optimize/quad_region.h"
#include "engine/optimize/ring_filling.h"
#include "engine/optimize/vertex_news.h"

namespace af2 {
namespace {

/// Vertices around a vertex in the order of their distances, with the ways back to it.
class NearVertices {
 public:
  explicit NearVertices(const MeshTopology& topology) : topology_(topology) {}

  void collect(VertexId seed) {
    constexpr int kReach = 7;
    constexpr std::size_t kMost = 250;
    isSeen_.resize(topology_.mesh().vertices.size(), 0);
    near_.assign(1, {seed, 0, 0});
    isSeen_[seed.value] = 1;
    for (std::size_t i = 0; i < near_.size() && near_.size() < kMost; ++i) {
      if (near_[i].distance == kReach) break;
      topology_.forEachNeighborOf(near_[i].vertex, [&](VertexId v) {
        if (std::exchange(isSeen_[v.value], 1) == 0) near_.push_back({v, i, near_[i].distance + 1});
      });
    }
    for (const Near& near : near_) isSeen_[near.vertex.value] = 0;
  }

  std::size_t count() const { return near_.size(); }
  VertexId at(std::size_t i) const { return near_[i].vertex; }
  /// The place of the next vertex on the way to the first one.
  std::size_t before(std::size_t i) const { return near_[i].before; }

 private:
  struct Near {
    VertexId vertex;
    std::size_t before;
    int distance;
  };
  const MeshTopology& topology_;
  std::vector<Near> near_;
  std::vector<std::uint8_t> isSeen_;  ///< by vertex
};

/// Gives the vertices of a filling numbers in the patch: those of the ring keep theirs, those that
/// were inside the region are used again, and what is missing is added.
class Numbering {
 public:
  Numbering(QuadPatch& patch, std::vector<Point2>& points) : patch_(patch), points_(points) {}

  void addRing(QuadPatch::Vertex v) { numbers_.push_back(v); }
  void addFree(QuadPatch::Vertex v) { free_.push_back(v); }
  /// Returns false if the patch has no room.
  bool addInner(Point2 point) {
    if (next_ < free_.size()) {
      numbers_.push_back(free_[next_++]);
      points_[numbers_.back()] = point;
      return true;
    }
    const std::optional<QuadPatch::Vertex> added = patch_.addInner(0);
    if (!added) return false;
    numbers_.push_back(*added);
    points_.push_back(point);
    return true;
  }
  QuadPatch::Ring ringOf(const std::array<std::size_t, 4>& quad) const {
    return {numbers_[quad[0]], numbers_[quad[1]], numbers_[quad[2]], numbers_[quad[3]]};
  }

 private:
  QuadPatch& patch_;
  std::vector<Point2>& points_;
  std::vector<QuadPatch::Vertex> numbers_, free_;
  std::size_t next_ = 0;
};

class PatchFiller {
 public:
  PatchFiller(PatchEditor& editor, const FillingEffort& effort)
      : editor_(editor),
        effort_(effort),
        topology_(editor.topology()),
        region_(editor, effort.elements),
        near_(topology_),
        news_(topology_.mesh().vertices.size()) {}

  std::size_t pass(const WorkWatch& watch) {
    std::size_t filled = 0;
    for (std::size_t v = 0; v < topology_.mesh().vertices.size(); ++v) {
      const VertexId seed(v);
      while (editor_.irregularity(seed) > 0 && news_.isNews(seed)) {
        if (watch.mustStop()) return filled;
        news_.look(seed);
        if (!improveTowards(seed) && !improveAround(seed)) break;
        ++filled;
      }
    }
    return filled;
  }

 private:
  /// The region reaches from the seed to one irregular vertex after another.
  bool improveTowards(VertexId seed) {
    near_.collect(seed);
    region_.clear();
    region_.addStar(seed);
    int others = 0;
    for (std::size_t i = 1; i < near_.count() && others < effort_.others; ++i) {
      if (editor_.irregularity(near_.at(i)) == 0 || isInside(near_.at(i))) continue;
      for (std::size_t k = i; k != 0; k = near_.before(k)) region_.addStar(near_.at(k));
      ++others;
      if (!region_.makeConvex()) return false;
      if (fill(seed)) return true;
    }
    return false;
  }

  /// The region grows by one ring of elements after another.
  bool improveAround(VertexId seed) {
    region_.clear();
    region_.addStar(seed);
    for (int layer = 0; layer < effort_.layers; ++layer) {
      if (!region_.makeConvex()) return false;
      if (fill(seed)) return true;
      region_.addLayer();
    }
    return false;
  }

  bool isInside(VertexId v) const {
    bool isInside = true;
    topology_.forEachCornerOf(v, [&](Corner c) { isInside &= region_.has(c.element()); });
    return isInside;
  }

  bool fill(VertexId seed) {
    const std::optional<RegionRing> ring = region_.ring();
    if (!ring || !isNew() || !editor_.take(seed, region_.elements())) return false;
    const std::optional<PatchJacobians> before = editor_.jacobians();
    if (!before) return false;
    findInside(*ring);
    if (std::ranges::any_of(inside_, [&](VertexId v) { return topology_.isFixed(v); }))
      return false;
    const Ring outline = outlineOf(*ring);
    const PatchJacobians wanted = acceptableAfter(*before);
    for (const FillingPlan& plan : fillingPlans(outline, mostIrregular(*ring), effort_.plans))
      if (putBack(*ring, fillRing(outline, plan), wanted)) {
        news_.noteChange(editor_.vertices(), topology_.mesh().vertices.size());
        return true;
      }
    return false;
  }

  /// Whether the region was not tried before.
  bool isNew() {
    std::vector<std::size_t> elements = region_.elements();
    std::ranges::sort(elements);
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a
    for (const std::size_t e : elements)
      for (const VertexId v : topology_.mesh().elements[e].vertices())
        hash = (hash ^ v.value) * 1099511628211u;
    return tried_.insert(hash).second;
  }

  /// The vertices of the region that are not on its ring, in order.
  void findInside(const RegionRing& ring) {
    inside_.clear();
    for (const std::size_t e : region_.elements())
      for (const VertexId v : topology_.mesh().elements[e].vertices()) inside_.push_back(v);
    std::ranges::sort(inside_);
    inside_.erase(std::unique(inside_.begin(), inside_.end()), inside_.end());
    std::vector<VertexId> outside = ring.vertices;
    std::ranges::sort(outside);
    std::erase_if(inside_, [&](VertexId v) { return std::ranges::binary_search(outside, v); });
  }

  Ring outlineOf(const RegionRing& ring) {
    Ring outline;
    outline.corners = ring.corners;
    for (const VertexId v : ring.vertices) {
      outline.points.push_back(editor_.points()[editor_.find(v)]);
      outline.mayChange.push_back(topology_.isFixed(v) ? 0 : 1);
    }
    return outline;
  }

  /// Fewer than now.
  int mostIrregular(const RegionRing& ring) const {
    constexpr int kIrregular = kRightAngle * kRightAngle;  // energy of one vertex
    int energy = 0;
    for (const std::vector<VertexId>& vertices : {inside_, ring.vertices})
      for (const VertexId v : vertices) energy += editor_.patch().energyAt(editor_.find(v));
    return (energy - 1) / kIrregular;
  }

  bool putBack(const RegionRing& ring, const RingFilling& filling, const PatchJacobians& wanted) {
    QuadPatch patch = editor_.patch();
    std::vector<Point2> points = editor_.points();
    Numbering numbering(patch, points);
    for (const VertexId v : ring.vertices) numbering.addRing(editor_.find(v));
    for (const VertexId v : inside_) numbering.addFree(editor_.find(v));
    for (std::size_t i = ring.vertices.size(); i < filling.points.size(); ++i)
      if (!numbering.addInner(filling.points[i])) return false;
    std::vector<std::size_t> gone;
    for (const std::size_t e : region_.elements()) gone.push_back(*editor_.find(e));
    std::vector<QuadPatch::Ring> rings;
    for (const auto& quad : filling.quads) rings.push_back(numbering.ringOf(quad));
    if (!patch.refill(gone, rings) || patch.energy() >= editor_.patch().energy()) return false;
    return editor_.putBack(patch, std::move(points), wanted, FinishAct::Kind::Search);
  }

  PatchEditor& editor_;
  const FillingEffort& effort_;
  const MeshTopology& topology_;
  QuadRegion region_;
  NearVertices near_;
  VertexNews news_;
  std::set<std::uint64_t> tried_;  ///< the regions, by hashes of their elements
  std::vector<VertexId> inside_;
};

}  // namespace

std::size_t fillPatches(PatchEditor& editor, const FillingEffort& effort, const WorkWatch& watch) {
  constexpr int kMaxPasses = 3;
  PatchFiller filler(editor, effort);
  std::size_t filled = 0;
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    const std::size_t more = filler.pass(watch);
    filled += more;
    if (more == 0) break;
  }
  return filled;
}

}  // namespace af2
