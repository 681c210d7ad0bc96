#include "engine/run/region_split.h"

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/run/even_cuts.h"
#include "engine/run/region_cuts.h"
#include "engine/run/region_elements.h"
#include "engine/run/region_loops.h"

namespace af2 {
namespace {

using namespace region;

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
    const double expected =
        expectedElements(loops, plane, isReversed_, surface_, size_, options_.pieceElements);
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
      if (!isReversed_) return cutsThrough(loops, plane, surface_, size_);
      const Mirror mirror(surface_);
      const MirrorSize mirrorSize(size_);
      Loops mirrored = loops;
      for (Loop& loop : mirrored)
        for (BoundaryCorner& c : loop) std::swap(c.point.u, c.point.v);
      std::vector<Cut> cuts =
          cutsThrough(mirrored, {plane.scaleV, plane.scaleU}, mirror, mirrorSize);
      for (Cut& cut : cuts)
        for (SurfacePoint& p : cut.inner) std::swap(p.u, p.v);
      return cuts;
    } catch (const GeometryError&) {
      return {};  // a line meets a point without a normal: the region stays whole
    }
  }

  std::vector<Cut> cutsThrough(const Loops& loops, const Plane& plane,
                               const SurfaceEvaluator& surface, const SizeField& size) const {
    const CutEnds ends = options_.evenPieces ? CutEnds::Straight : CutEnds::Nearest;
    std::vector<Cut> cuts = findCuts(loops, plane, surface, size, ends);
    if (options_.evenPieces) makePiecesEven(loops, surface, size, cuts);
    return cuts;
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
