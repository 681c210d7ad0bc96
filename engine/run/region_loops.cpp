#include "engine/run/region_loops.h"

#include <utility>

#include "engine/base/predicates.h"

namespace af2::region {
namespace {

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

}  // namespace

double signedArea(const Loop& loop, const Plane& plane) {
  double twice = 0;
  const Point2 origin = plane.at(loop[0]);
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    twice += cross(plane.at(loop[i]) - origin, plane.at(loop[i + 1]) - origin);
  return 0.5 * twice;
}

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

}  // namespace af2::region
