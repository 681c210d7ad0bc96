#include "geometry/deviation/thinned_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "geometry/base/nearest_on_segment.h"
#include "geometry/mesh/unused_vertices.h"

namespace af2::geometry {
namespace {

/// Height of a triangle over its longest side: below this it is a needle.
constexpr double kLeastHeight = 0.02;
/// Cosine of the angle by which a triangle may turn when a corner moves.
constexpr double kLeastTurned = 0.5;

double heightOverSide(const Point3& a, const Point3& b, const Point3& c) {
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  return longest > 0 ? length(cross(b - a, c - a)) / (longest * longest) : 0;
}

/// Elements and segments around each vertex, while vertices are moved onto others.
class Thinning {
 public:
  Thinning(ModelMesh& mesh, EdgeCurves& curves, const DeviationTask& task,
           const ThinningLimits& limits)
      : mesh_(mesh),
        curves_(curves),
        task_(task),
        limits_(limits),
        elementsAt_(mesh.vertices.size()),
        segmentsAt_(mesh.vertices.size()),
        isFixed_(mesh.vertices.size(), 0),
        isGone_(mesh.elements.size(), 0),
        isSegmentGone_(mesh.segments.size(), 0) {
    for (std::uint32_t e = 0; e < mesh.elements.size(); ++e)
      for (const VertexId v : mesh.elements[e].vertices()) {
        elementsAt_[v.value].push_back(e);
        if (mesh.elements[e].isQuad()) isFixed_[v.value] = 1;
      }
    for (std::uint32_t s = 0; s < mesh.segments.size(); ++s)
      for (const VertexId v : {mesh.segments[s].from, mesh.segments[s].to})
        segmentsAt_[v.value].push_back(s);
    fixEndsOfEdges();
    for (std::size_t v = 0; v < limits.isKept.size(); ++v) isFixed_[v] |= limits.isKept[v];
  }

  std::size_t run() {
    std::size_t removed = 0;
    for (std::size_t inSweep = 1; inSweep > 0; removed += inSweep) inSweep = sweep();
    if (removed > 0) compact();
    return removed;
  }

 private:
  /// In each sweep, the neighbours of a vertex that went stay, so that vertices go evenly.
  std::size_t sweep() {
    std::size_t removed = 0;
    std::vector<std::uint8_t> rests(mesh_.vertices.size(), 0);
    for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v) {
      if (isFixed_[v] || rests[v] || elementsAt_[v].empty()) continue;
      const std::optional<std::uint32_t> onto = bestNeighbour(v);
      if (!onto) continue;
      for (const std::uint32_t w : neighboursOf(v)) rests[w] = 1;
      move(v, *onto);
      ++removed;
    }
    return removed;
  }

  void fixEndsOfEdges() {
    std::map<int, std::pair<std::uint32_t, std::uint32_t>> ends;
    for (const EdgeSegment& segment : mesh_.segments) {
      ends.try_emplace(segment.edge, segment.from.value, 0).first->second.second = segment.to.value;
    }
    for (const auto& [edge, of] : ends) isFixed_[of.first] = isFixed_[of.second] = 1;
    for (std::uint32_t v = 0; v < segmentsAt_.size(); ++v) {
      const auto& at = segmentsAt_[v];
      if (at.empty()) continue;
      const bool isInside = at.size() == 2 && edgeOf(at[0]) == edgeOf(at[1]) &&
                            mesh_.segments[at[0]].uses == mesh_.segments[at[1]].uses;
      if (!isInside) isFixed_[v] = 1;
    }
  }
  int edgeOf(std::uint32_t segment) const { return mesh_.segments[segment].edge; }

  std::vector<std::uint32_t> neighboursOf(std::uint32_t v) const {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t e : elementsAt_[v])
      for (const VertexId w : mesh_.elements[e].vertices())
        if (w.value != v) found.push_back(w.value);
    std::ranges::sort(found);
    found.erase(std::ranges::unique(found).begin(), found.end());
    return found;
  }

  std::uint32_t otherEnd(std::uint32_t segment, std::uint32_t v) const {
    const EdgeSegment& s = mesh_.segments[segment];
    return s.from.value == v ? s.to.value : s.from.value;
  }

  /// The neighbour onto which a vertex may move so that the worst new triangle is best.
  std::optional<std::uint32_t> bestNeighbour(std::uint32_t v) {
    std::vector<std::uint32_t> candidates = neighboursOf(v);
    if (!segmentsAt_[v].empty()) {
      candidates.clear();
      for (const std::uint32_t s : segmentsAt_[v]) candidates.push_back(otherEnd(s, v));
      if (candidates[0] == candidates[1]) return std::nullopt;
    }
    std::vector<std::pair<double, std::uint32_t>> ranked;
    for (const std::uint32_t w : candidates)
      if (const double quality = qualityOf(v, w); quality > 0) ranked.emplace_back(-quality, w);
    std::ranges::sort(ranked);
    for (const auto& [quality, w] : ranked)
      if (keepsChord(v) && keepsBounds(v, w)) return w;
    return std::nullopt;
  }

  template <class Use>
  void forEachNew(std::uint32_t v, std::uint32_t onto, const Use& use) const {
    for (const std::uint32_t e : elementsAt_[v]) {
      const Element& element = mesh_.elements[e];
      std::array<std::uint32_t, 3> now{};
      bool vanishes = false;
      for (std::size_t i = 0; i < 3; ++i) {
        now[i] = element.corners[i].value;
        vanishes = vanishes || now[i] == onto;
      }
      if (vanishes) continue;
      std::array<std::uint32_t, 3> next = now;
      std::ranges::replace(next, v, onto);
      use(e, now, next);
    }
  }

  /// Height over side of the worst new triangle; 0: the move is not possible.
  double qualityOf(std::uint32_t v, std::uint32_t onto) const {
    if (!keepsTopology(v, onto)) return 0;
    double worst = std::numeric_limits<double>::infinity(), worstNow = worst;
    forEachNew(v, onto, [&](std::uint32_t, const auto& now, const auto& next) {
      const auto &a = at(now[0]), &b = at(now[1]), &c = at(now[2]);
      const auto &p = at(next[0]), &q = at(next[1]), &r = at(next[2]);
      worstNow = std::min(worstNow, heightOverSide(a, b, c));
      const Point3 before = cross(b - a, c - a), after = cross(q - p, r - p);
      const bool isTurned = !(dot(before, after) > kLeastTurned * length(before) * length(after));
      const bool isLong =
          std::max({distance(p, q), distance(q, r), distance(r, p)}) > limits_.longest;
      worst = isTurned || isLong ? 0 : std::min(worst, heightOverSide(p, q, r));
    });
    return worst >= std::min(kLeastHeight, worstNow) && std::isfinite(worst) ? worst : 0;
  }

  /// A vertex may move along a side if all that both its ends have in common are the triangles at
  /// the side; else the mesh would touch itself.
  bool keepsTopology(std::uint32_t v, std::uint32_t onto) const {
    std::set<std::uint32_t> opposite;
    for (const std::uint32_t e : elementsAt_[v]) {
      const auto corners = mesh_.elements[e].vertices();
      if (std::ranges::count(corners, VertexId(onto)) == 0) continue;
      for (const VertexId w : corners)
        if (w.value != v && w.value != onto) opposite.insert(w.value);
    }
    std::vector<std::uint32_t> common;
    std::ranges::set_intersection(neighboursOf(v), neighboursOf(onto), std::back_inserter(common));
    if (opposite.empty() || common.size() != opposite.size()) return false;
    // Along an edge, two segments become one; there must be none between the same ends already.
    if (segmentsAt_[v].empty()) return true;
    const std::uint32_t first = otherEnd(segmentsAt_[v][0], v),
                        last = otherEnd(segmentsAt_[v][1], v);
    const std::vector<std::uint32_t> around = neighboursOf(first);
    return !std::ranges::binary_search(around, last);
  }

  /// Along an edge: whether the chord keeps the bound.
  bool keepsChord(std::uint32_t v) const {
    if (segmentsAt_[v].empty()) return true;
    const std::uint32_t s = segmentsAt_[v][0], t = segmentsAt_[v][1];
    const Point3 &from = at(otherEnd(s, v)), &to = at(otherEnd(t, v));
    const double bound = std::min(task_.boundsOfSegments[s], task_.boundsOfSegments[t]);
    const auto isNear = [&](const Point3& p) {
      return distance(p, nearestOnSegment(p, from, to)) <= bound;
    };
    return isNear(at(v)) && std::ranges::all_of(curves_[s], isNear) &&
           std::ranges::all_of(curves_[t], isNear);
  }

  bool keepsBounds(std::uint32_t v, std::uint32_t onto) {
    bool keeps = true;
    forEachNew(v, onto, [&](std::uint32_t e, const auto&, const auto& next) {
      if (!keeps) return;
      const int face = mesh_.face[e];
      FaceDistance* surface = surfaceOf(face);
      keeps = !surface || farthestOf(at(next[0]), at(next[1]), at(next[2]), *surface).distance <=
                              task_.boundOf(face);
    });
    return keeps;
  }

  FaceDistance* surfaceOf(int face) {
    const auto found = surfaces_.find(face);
    if (found != surfaces_.end()) return found->second.get();
    return surfaces_.emplace(face, task_.distanceFrom(face)).first->second.get();
  }

  void move(std::uint32_t v, std::uint32_t onto) {
    for (const std::uint32_t e : elementsAt_[v]) {
      Element& element = mesh_.elements[e];
      const auto corners = element.vertices();
      if (std::ranges::count(corners, VertexId(onto)) > 0) {
        isGone_[e] = 1;
        for (const VertexId w : corners)
          if (w.value != v) std::erase(elementsAt_[w.value], e);
        continue;
      }
      std::ranges::replace(element.corners, VertexId(v), VertexId(onto));
      elementsAt_[onto].push_back(e);
    }
    elementsAt_[v].clear();
    if (!segmentsAt_[v].empty()) joinSegments(v);
  }

  /// The earlier one of both segments at a vertex takes in the other.
  void joinSegments(std::uint32_t v) {
    const auto [s, t] = std::minmax(segmentsAt_[v][0], segmentsAt_[v][1]);
    EdgeSegment &kept = mesh_.segments[s], &gone = mesh_.segments[t];
    const bool isAfter = gone.from.value == v;
    std::vector<Point3> curve = isAfter ? curves_[s] : curves_[t];
    const std::vector<Point3>& rest = isAfter ? curves_[t] : curves_[s];
    curve.push_back(at(v));
    curve.insert(curve.end(), rest.begin(), rest.end());
    (isAfter ? kept.to : kept.from) = isAfter ? gone.to : gone.from;
    curves_[s] = std::move(curve);
    isSegmentGone_[t] = 1;
    auto& atEnd = segmentsAt_[isAfter ? gone.to.value : gone.from.value];
    std::ranges::replace(atEnd, t, s);
    segmentsAt_[v].clear();
  }

  void compact() {
    std::map<int, std::size_t> byFace;
    std::size_t kept = 0;
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      if (isGone_[e]) continue;
      mesh_.elements[kept] = mesh_.elements[e];
      mesh_.face[kept] = mesh_.face[e];
      mesh_.origins[kept++] = mesh_.origins[e];
      ++byFace[mesh_.face[e]];
    }
    mesh_.elements.resize(kept);
    mesh_.face.resize(kept);
    mesh_.origins.resize(kept);
    for (FaceReport& face : mesh_.faces)
      if (face.elements > 0) face.elements = byFace[face.id];
    compactSegments();
    dropUnusedVertices(mesh_);
  }

  void compactSegments() {
    std::size_t kept = 0;
    for (std::size_t s = 0; s < mesh_.segments.size(); ++s) {
      if (isSegmentGone_[s]) continue;
      mesh_.segments[kept] = mesh_.segments[s];
      curves_[kept++] = std::move(curves_[s]);
    }
    mesh_.segments.resize(kept);
    curves_.resize(kept);
  }

  const Point3& at(std::uint32_t v) const { return mesh_.vertices[v]; }

  ModelMesh& mesh_;
  EdgeCurves& curves_;
  const DeviationTask& task_;
  const ThinningLimits& limits_;
  std::vector<std::vector<std::uint32_t>> elementsAt_, segmentsAt_;  // by vertex
  std::vector<std::uint8_t> isFixed_;                                // by vertex
  std::vector<std::uint8_t> isGone_;                                 // by element
  std::vector<std::uint8_t> isSegmentGone_;
  std::map<int, std::unique_ptr<FaceDistance>> surfaces_;
};

}  // namespace

std::size_t thin(ModelMesh& mesh, EdgeCurves& curves, const DeviationTask& task,
                 const ThinningLimits& limits) {
  return Thinning(mesh, curves, task, limits).run();
}

}  // namespace af2::geometry
