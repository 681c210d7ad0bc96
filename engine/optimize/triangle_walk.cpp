#include "engine/optimize/triangle_walk.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "engine/optimize/quad_division.h"
#include "engine/optimize/quad_search.h"

namespace af2 {
namespace {

using Ring = QuadPatch::Ring;

class TriangleWalk {
 public:
  /// leastJacobian  that elements may have behind the triangles; the search and smoothing follow
  TriangleWalk(PatchEditor& editor, double leastJacobian)
      : editor_(editor), topology_(editor.topology()), leastJacobian_(leastJacobian) {}

  /// Walks from a triangle to another one at most `reach` elements away. Returns whether they met.
  bool pair(std::size_t triangle, int reach) {
    for (const std::vector<std::size_t>& path : pathsFrom(triangle, 1, reach))
      if (walk(path)) return true;
    return false;
  }

  /// Divides the elements between the triangle and another one.
  bool divide(std::size_t triangle, int reach) {
    for (const std::vector<std::size_t>& path : pathsFrom(triangle, 2, reach))
      if (isWay(path) && divideInStages(path)) return true;
    if (!isTriangle(triangle)) return false;
    for (std::size_t side = 0; side < 3; ++side) {
      const Corner beyond = topology_.across(Corner(triangle, side));
      if (!beyond.isNone() && isTriangle(beyond.element()) &&
          divideInRing(editor_, triangle, beyond.element(), leastJacobian_))
        return true;
    }
    return false;
  }

  /// The same after a step of the triangle to one of its neighbours: two triangles at a straight
  /// boundary may have no way but around.
  bool pairAfterDetour(std::size_t triangle, int reach) {
    for (std::size_t side = 0; side < 3 && isTriangle(triangle); ++side) {
      const Corner in = topology_.across(Corner(triangle, side));
      if (in.isNone() || topology_.sizeOf(in) == 3) continue;
      for (Corner out = topology_.next(in); out != in; out = topology_.next(out)) {
        const Corner after = topology_.across(out);
        if (after.isNone()) continue;
        const std::optional<std::size_t> moved = step(triangle, in.element(), after.element());
        if (!moved) continue;
        if (pair(*moved, reach) || divide(*moved, reach)) return true;
        triangle = *moved;  // it goes on from there
        break;
      }
    }
    return false;
  }

 private:
  bool isTriangle(std::size_t e) const {
    return !topology_.isDead(e) && !topology_.mesh().elements[e].isQuad();
  }

  /// Elements from other triangles, the nearest first, to this one; at most a few.
  ///
  /// least, reach  bounds of the distance to the other triangle on the way, in elements
  std::vector<std::vector<std::size_t>> pathsFrom(std::size_t triangle, int least, int reach) {
    constexpr std::size_t kPaths = 3;
    std::vector<std::vector<std::size_t>> paths;
    towards_.resize(topology_.mesh().elements.size(), kUnseen);
    distance_.resize(towards_.size(), 0);
    std::vector<std::size_t> seen{triangle};
    towards_[triangle] = triangle;
    distance_[triangle] = 0;
    for (std::size_t i = 0; i < seen.size() && paths.size() < kPaths; ++i) {
      const std::size_t e = seen[i];
      if (e != triangle && isTriangle(e)) {
        std::vector<std::size_t>& path = paths.emplace_back(1, e);
        while (path.back() != triangle) path.push_back(towards_[path.back()]);
        continue;
      }
      if (distance_[e] == reach) continue;
      const auto sides = static_cast<std::size_t>(topology_.mesh().elements[e].size());
      for (std::size_t k = 0; k < sides; ++k) {
        const Corner beyond = topology_.across(Corner(e, k));
        if (beyond.isNone() || towards_[beyond.element()] != kUnseen) continue;
        if (distance_[e] + 1 < least && isTriangle(beyond.element())) continue;
        towards_[beyond.element()] = e;
        distance_[beyond.element()] = distance_[e] + 1;
        seen.push_back(beyond.element());
      }
    }
    for (const std::size_t e : seen) towards_[e] = kUnseen;
    return paths;
  }

  /// An earlier walk that ended on its way may have changed the elements of the path.
  bool walk(const std::vector<std::size_t>& path) {
    std::size_t here = path.front();
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (!isTriangle(here) || topology_.isDead(path[i])) return false;
      const bool isMet = isTriangle(path[i]);
      const std::optional<std::size_t> next =
          step(here, path[i], path[std::min(i + 1, path.size() - 1)]);
      if (!next || isMet) return isMet && next;
      here = *next;
    }
    return false;
  }

  /// Whether no earlier attempt has changed the elements of the path.
  bool isWay(std::span<const std::size_t> path) const {
    for (std::size_t i = 0; i < path.size(); ++i) {
      const bool isEnd = i == 0 || i + 1 == path.size();
      if (topology_.isDead(path[i]) || isTriangle(path[i]) != isEnd) return false;
      if (i > 0 && sideTowards(topology_, path[i], path[i - 1]).isNone()) return false;
    }
    return true;
  }

  /// A part of the way at a time, as far as a patch and its chart reach.
  bool divideInStages(std::span<const std::size_t> path) {
    constexpr std::array<std::size_t, 3> kStages{24, 8, 4};
    if (path.size() <= kStages[0] && divideAlong(editor_, path, std::nullopt, leastJacobian_))
      return true;
    for (const std::size_t stage : kStages)
      if (stage < path.size() &&
          divideAlong(editor_, path.first(stage), path[stage], leastJacobian_))
        return divideTheRest(path.subspan(stage));
    return false;
  }

  /// rest  begins at the element beyond the triangle, and ends with the other triangle, which may
  ///       also be beside that element
  bool divideTheRest(std::span<const std::size_t> rest) {
    const auto sides = static_cast<std::size_t>(topology_.mesh().elements[rest[0]].size());
    for (std::size_t k = 0; k < sides; ++k) {
      const Corner across = topology_.across(Corner(rest[0], k));
      if (across.isNone() || !isTriangle(across.element()) || across.element() == rest.back())
        continue;
      std::vector<std::size_t> path(rest.begin(), rest.end());
      path.insert(path.begin(), across.element());
      return divideInStages(path);
    }
    return false;
  }

  /// Moves the triangle into the next element of its path, towards the one after it. Returns where
  /// the triangle is then; at the end of the path, any element.
  std::optional<std::size_t> step(std::size_t triangle, std::size_t into, std::size_t after) {
    const Corner out = sideTowards(topology_, triangle, into);
    if (out.isNone() || !editor_.take(topology_.vertexAt(out))) return std::nullopt;
    const auto here = editor_.find(triangle), there = editor_.find(into);
    if (!here || !there) return std::nullopt;
    const auto at = [&](Corner c) { return editor_.find(topology_.vertexAt(c)); };
    const Corner in = topology_.across(out);
    const QuadPatch::Vertex third = at(topology_.previous(out)), to = at(in),
                            from = at(topology_.next(in));
    constexpr QuadPatch::Vertex kNone = QuadPatch::kNone;
    if (topology_.sizeOf(in) == 3) {
      const Ring whole{third, from, at(topology_.previous(in)), to};
      return join(*here, whole, *there) ? std::optional(triangle) : std::nullopt;
    }
    const Corner ahead = topology_.next(topology_.next(in));
    const QuadPatch::Vertex m = at(ahead), n = at(topology_.next(ahead));
    const Corner side = sideTowards(topology_, into, after);
    std::optional<std::size_t> end;
    if (side != topology_.previous(in))  // the sides from -> m and m -> n remain open
      end = redivide(*here, {third, from, n, to}, *there, {from, m, n, kNone});
    if (!end && side != topology_.next(in))
      end = redivide(*here, {third, from, m, to}, *there, {m, n, to, kNone});
    return end;
  }

  /// Two triangles become one quadrilateral. At a straight boundary it would be flat: then the
  /// elements around it have to change as well.
  bool join(std::size_t one, const Ring& whole, std::size_t other) {
    constexpr QuadPatch::Vertex kNone = QuadPatch::kNone;
    constexpr int kDepth = 3;
    QuadPatch joined = editor_.patch();
    if (!joined.replace(one, whole, other, {kNone, kNone, kNone, kNone})) return false;
    const auto putBack = [&](const QuadPatch& patch) {
      return editor_.putBack(patch, {leastJacobian_}, FinishAct::Kind::Pairing);
    };
    return putBack(joined) || std::ranges::any_of(betterPatches(joined, kDepth), putBack);
  }

  /// Returns the element of the mesh that has the second ring.
  std::optional<std::size_t> redivide(std::size_t one, const Ring& ring, std::size_t other,
                                      const Ring& rest) {
    QuadPatch changed = editor_.patch();
    if (!changed.replace(one, ring, other, rest)) return std::nullopt;
    if (!editor_.putBack(changed, {leastJacobian_}, FinishAct::Kind::Pairing)) return std::nullopt;
    return elementBetween(editor_.vertexAt(rest[0]), editor_.vertexAt(rest[1]));
  }

  /// The element that has a side from one vertex to the other.
  std::optional<std::size_t> elementBetween(VertexId from, VertexId to) const {
    const Corner first = topology_.cornerOf(from);
    for (Corner c = first; !c.isNone();) {
      if (topology_.vertexAt(topology_.next(c)) == to) return c.element();
      c = topology_.aroundVertex(c);
      if (c == first) break;
    }
    return std::nullopt;
  }

  static constexpr std::size_t kUnseen = std::numeric_limits<std::size_t>::max();
  PatchEditor& editor_;
  const MeshTopology& topology_;
  double leastJacobian_;
  std::vector<std::size_t> towards_;  ///< by element: the next one towards the triangle
  std::vector<int> distance_;         ///< by element, in elements
};

}  // namespace

std::size_t walkTriangles(PatchEditor& editor, const WorkWatch& watch) {
  constexpr int kAnywhere = std::numeric_limits<int>::max();
  constexpr std::array kReaches{2, 8, 32, kAnywhere};
  constexpr std::array kLeastJacobians{0.3, 0.1, 0.02, 0.002};  // the last one for slivers
  std::size_t pairs = 0;
  const MeshTopology& topology = editor.topology();
  const auto forEachTriangle = [&](const auto& pair) {
    for (std::size_t e = 0; e < topology.mesh().elements.size(); ++e) {
      if (watch.mustStop()) return;
      if (!topology.isDead(e) && !topology.mesh().elements[e].isQuad()) pairs += pair(e) ? 1 : 0;
    }
  };
  for (const double least : kLeastJacobians) {
    TriangleWalk walk(editor, least);
    for (const int reach : kReaches)
      forEachTriangle([&](std::size_t e) { return walk.pair(e, reach); });
    for (const int reach : kReaches)
      forEachTriangle([&](std::size_t e) { return walk.divide(e, reach); });
    forEachTriangle([&](std::size_t e) { return walk.pairAfterDetour(e, kAnywhere); });
  }
  return pairs;
}

}  // namespace af2
