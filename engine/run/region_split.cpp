#include "engine/run/region_split.h"

#include <algorithm>
#include <cmath>

#include "engine/base/constants.h"
#include "engine/base/error.h"
#include "engine/base/predicates.h"
#include "engine/run/region_cuts.h"

namespace af2 {
namespace {

using namespace region;

double signedArea(const Loop& loop, const Plane& plane) {
  double twice = 0;
  const Point2 origin = plane.at(loop[0]);
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    twice += cross(plane.at(loop[i]) - origin, plane.at(loop[i + 1]) - origin);
  return 0.5 * twice;
}

/// Relinks the loops along the cuts: at each end of a cut the incoming edge continues along it.
Loops relink(const Loops& loops, const std::vector<Cut>& cuts, std::size_t firstCutVertex) {
  std::vector<std::size_t> first(loops.size() + 1, 0);
  for (std::size_t l = 0; l < loops.size(); ++l) first[l + 1] = first[l] + loops[l].size();
  std::vector<BoundaryCorner> corners;
  std::vector<std::size_t> next;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    for (std::size_t i = 0; i < loops[l].size(); ++i) {
      corners.push_back(loops[l][i]);
      next.push_back(first[l] + (i + 1) % loops[l].size());
    }
  }
  std::vector<std::size_t> previous(next.size());
  for (std::size_t i = 0; i < next.size(); ++i) previous[next[i]] = i;

  const auto add = [&](const BoundaryCorner& corner, std::size_t after) {
    corners.push_back(corner);
    next.push_back(0);
    if (after < corners.size() - 1) next[after] = corners.size() - 1;
    return corners.size() - 1;
  };
  std::size_t id = firstCutVertex;
  for (const Cut& cut : cuts) {
    const std::size_t a = first[cut.from.loop] + cut.from.corner;
    const std::size_t b = first[cut.to.loop] + cut.to.corner;
    // before a -> a' -> cut -> b -> after b, and before b -> b' -> cut reversed -> a -> after a
    const std::size_t beforeA = previous[a], beforeB = previous[b];
    const std::size_t a2 = add(corners[a], beforeA);
    std::size_t last = a2;
    for (std::size_t k = 0; k < cut.inner.size(); ++k)
      last = add({VertexId(id + k), cut.inner[k]}, last);
    next[last] = b;
    const std::size_t b2 = add(corners[b], beforeB);
    last = b2;
    for (std::size_t k = cut.inner.size(); k-- > 0;)
      last = add({VertexId(id + k), cut.inner[k]}, last);
    next[last] = a;
    id += cut.inner.size();
  }

  Loops result;
  std::vector<bool> isDone(corners.size(), false);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (isDone[i]) continue;
    result.emplace_back();
    for (std::size_t k = i; !isDone[k]; k = next[k]) {
      isDone[k] = true;
      result.back().push_back(corners[k]);
    }
  }
  return result;
}

bool encloses(const Loop& outer, Point2 p, const Plane& plane) {
  bool isInside = false;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    Point2 a = plane.at(outer[i]), b = plane.at(outer[(i + 1) % outer.size()]);
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (a.y > b.y) std::swap(a, b);
    if (orientation(a, b, p) == Turn::Left) isInside = !isInside;
  }
  return isInside;
}

/// Outer loops, each with the holes inside it; no value if a hole lies in none of them.
std::vector<Loops> regionsOf(Loops loops, const Plane& plane, bool isReversed) {
  std::vector<Loops> regions;
  std::vector<Loop> holes;
  std::vector<double> areas;
  for (Loop& loop : loops) {
    const double area = signedArea(loop, plane) * (isReversed ? -1 : 1);
    if (area > 0) {
      regions.push_back({std::move(loop)});
      areas.push_back(area);
    } else {
      holes.push_back(std::move(loop));
    }
  }
  for (Loop& hole : holes) {
    std::size_t home = regions.size();
    for (std::size_t r = 0; r < regions.size(); ++r)
      if (encloses(regions[r][0], plane.at(hole[0]), plane) &&
          (home == regions.size() || areas[r] < areas[home]))
        home = r;
    if (home == regions.size()) return {};
    regions[home].push_back(std::move(hole));
  }
  return regions;
}

class Splitter {
 public:
  Splitter(const FrontInput& input, const SurfaceEvaluator& surface, const SizeField& size,
           const SplitOptions& options)
      : input_(input), surface_(surface), size_(size), options_(options) {}

  SplitRegion split() {
    double area = 0;
    for (const Loop& loop : input_.loops) area += signedArea(loop, Plane{});
    isReversed_ = area < 0;
    // A region with isolated vertices is not cut: they are rare, and would have to be assigned to
    // pieces.
    if (input_.isolated.empty()) recurse(input_.loops, 0);
    if (result_.pieces.size() <= 1)
      result_.pieces = {whole(result_.pieces.empty() ? 0 : result_.pieces[0].expectedElements)};
    return std::move(result_);
  }

 private:
  void recurse(const Loops& loops, int depth) {
    const Plane plane = planeFor(loops);
    const double expected = expectedElements(loops, plane);
    if (expected > options_.pieceElements) {
      std::vector<Cut> cuts = tryToCut(loops, plane);
      if (!cuts.empty()) {
        const std::size_t firstId = input_.vertexCount + result_.cutVertices.size();
        const std::vector<Loops> parts =
            regionsOf(relink(loops, cuts, firstId), plane, isReversed_);
        if (parts.size() > 1) {
          divide(cuts, parts, depth);
          return;
        }
      }
    }
    result_.pieces.push_back(pieceOf(loops));
    result_.pieces.back().expectedElements = expected;
  }

  void divide(const std::vector<Cut>& cuts, const std::vector<Loops>& parts, int depth) {
    const std::size_t index = result_.cuts.size();
    RegionCut made{depth, {result_.cutVertices.size()}, {}, {result_.pieces.size()}};
    for (const Cut& cut : cuts)
      result_.cutVertices.insert(result_.cutVertices.end(), cut.inner.begin(), cut.inner.end());
    made.own.end = result_.cutVertices.size();
    result_.cuts.push_back(made);
    for (const Loops& part : parts) recurse(part, depth + 1);
    made.within = {made.own.begin, result_.cutVertices.size()};
    made.pieces.end = result_.pieces.size();
    result_.cuts[index] = made;
  }

  std::vector<Cut> tryToCut(const Loops& loops, const Plane& plane) const {
    try {
      // In the parameter plane a reversed face is mirrored: the region is on the right. Swapping u
      // and v corrects this.
      if (!isReversed_) return findCuts(loops, plane, surface_, size_);
      const Mirror mirror(surface_);
      const MirrorSize mirrorSize(size_);
      Loops mirrored = loops;
      for (Loop& loop : mirrored)
        for (BoundaryCorner& c : loop) std::swap(c.point.u, c.point.v);
      std::vector<Cut> cuts = findCuts(mirrored, {plane.scaleV, plane.scaleU}, mirror, mirrorSize);
      for (Cut& cut : cuts)
        for (SurfacePoint& p : cut.inner) std::swap(p.u, p.v);
      return cuts;
    } catch (const GeometryError&) {
      return {};  // a line meets a point without a normal: the region stays whole
    }
  }

  class Mirror final : public SurfaceEvaluator {
   public:
    explicit Mirror(const SurfaceEvaluator& surface) : surface_(surface) {}
    SurfacePoint at(double u, double v) const override {
      SurfacePoint p = surface_.at(v, u);
      std::swap(p.u, p.v);
      return p;
    }

   private:
    const SurfaceEvaluator& surface_;
  };

  class MirrorSize final : public SizeField {
   public:
    explicit MirrorSize(const SizeField& size) : size_(size) {}
    double sizeAt(const SurfacePoint& point) const override {
      SurfacePoint p = point;
      std::swap(p.u, p.v);
      return size_.sizeAt(p);
    }

   private:
    const SizeField& size_;
  };

  /// Lengths of the parameter lines through the middle of the region.
  Plane planeFor(const Loops& loops) const {
    Box box;
    forEachEdge(loops, [&](const BoundaryCorner& c, const BoundaryCorner&) {
      box.include({c.point.u, c.point.v});
    });
    const Point2 extent = box.high - box.low, middle = 0.5 * (box.low + box.high);
    if (!(extent.x > 0) || !(extent.y > 0)) return {};
    constexpr double kStep = 1e-3;
    try {
      const Point3 here = surface_.at(middle.x, middle.y).position;
      const double alongU =
          distance(here, surface_.at(middle.x + kStep * extent.x, middle.y).position);
      const double alongV =
          distance(here, surface_.at(middle.x, middle.y + kStep * extent.y).position);
      if (alongU > 0 && alongV > 0)
        return {alongU / (kStep * extent.x), alongV / (kStep * extent.y)};
    } catch (const GeometryError&) {
    }
    return {};
  }

  double expectedElements(const Loops& loops, const Plane& plane) const {
    double area = 0, lengths = 0, weights = 0;
    for (const Loop& loop : loops) area += signedArea(loop, plane);
    forEachEdge(loops, [&](const BoundaryCorner& c, const BoundaryCorner& d) {
      const double length = distance(c.point.position, d.point.position);
      lengths += length * size_.sizeAt(c.point);
      weights += length;
    });
    const double size = weights > 0 ? lengths / weights : 1;
    return std::abs(area) / (kUnitTriangle * size * size);
  }

  static RegionPiece pieceOf(const Loops& loops) {
    RegionPiece piece;
    forEachEdge(loops, [&](const BoundaryCorner& c, const BoundaryCorner&) {
      piece.vertices.push_back(c.vertex);
    });
    std::sort(piece.vertices.begin(), piece.vertices.end());
    piece.vertices.erase(std::unique(piece.vertices.begin(), piece.vertices.end()),
                         piece.vertices.end());
    piece.input.vertexCount = piece.vertices.size();
    piece.input.loops = loops;
    for (Loop& loop : piece.input.loops)
      for (BoundaryCorner& c : loop) c.vertex = localId(piece, c.vertex);
    return piece;
  }

  static VertexId localId(const RegionPiece& piece, VertexId id) {
    const auto at = std::lower_bound(piece.vertices.begin(), piece.vertices.end(), id);
    return VertexId(static_cast<std::size_t>(at - piece.vertices.begin()));
  }

  RegionPiece whole(double expectedElements) const {
    RegionPiece piece{input_, {}, expectedElements};
    for (std::size_t v = 0; v < input_.vertexCount; ++v) piece.vertices.push_back(VertexId(v));
    return piece;
  }

  const FrontInput& input_;
  const SurfaceEvaluator& surface_;
  const SizeField& size_;
  const SplitOptions& options_;
  bool isReversed_ = false;
  SplitRegion result_;
};

}  // namespace

SplitRegion splitRegion(const FrontInput& input, const SurfaceEvaluator& surface,
                        const SizeField& size, const SplitOptions& options) {
  return Splitter(input, surface, size, options).split();
}

}  // namespace af2
