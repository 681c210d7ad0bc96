#include "engine/front/input_check.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/place_text.h"

namespace af2 {
namespace {

bool isFinite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

std::string nameOf(VertexId id) { return "vertex " + std::to_string(id.value); }

void checkCorner(const FrontInput& input, const BoundaryCorner& corner, std::vector<Point3>& at,
                 std::vector<bool>& isKnown) {
  const std::size_t v = corner.vertex.value;
  if (v >= input.vertexCount)
    throw InputError("boundary: " + nameOf(corner.vertex) + " is not below the vertex count " +
                     std::to_string(input.vertexCount));
  if (!isFinite(corner.point.position) || !isFinite(corner.point.normal))
    throw InputError("boundary: " + nameOf(corner.vertex) +
                     " has a coordinate that is not a finite number");
  if (isKnown[v] && at[v] != corner.point.position)
    throw InputError("boundary: " + nameOf(corner.vertex) + " is given with two positions");
  at[v] = corner.point.position;
  isKnown[v] = true;
}

}  // namespace

void checkInput(const FrontInput& input) {
  std::vector<Point3> at(input.vertexCount);
  std::vector<bool> isKnown(input.vertexCount, false);
  std::vector<std::pair<VertexId, VertexId>> edges;
  for (const auto& loop : input.loops) {
    if (loop.size() < 2) throw InputError("boundary: a loop has fewer than two corners");
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const BoundaryCorner& corner = loop[i];
      const BoundaryCorner& next = loop[(i + 1) % loop.size()];
      checkCorner(input, corner, at, isKnown);
      if (corner.vertex == next.vertex || corner.point.position == next.point.position)
        throw InputError("boundary: the edge from " + nameOf(corner.vertex) + " to " +
                         nameOf(next.vertex) + " has length zero");
      edges.emplace_back(corner.vertex, next.vertex);
    }
  }
  for (const BoundaryCorner& corner : input.isolated) {
    const bool isTaken = corner.vertex.value < isKnown.size() && isKnown[corner.vertex.value];
    checkCorner(input, corner, at, isKnown);
    if (isTaken)
      throw InputError("boundary: " + nameOf(corner.vertex) +
                       " is given as isolated, but it is on a loop or given before");
  }
  std::sort(edges.begin(), edges.end());
  const auto twice = std::adjacent_find(edges.begin(), edges.end());
  if (twice != edges.end())
    throw InputError("boundary: the edge from " + nameOf(twice->first) + " to " +
                     nameOf(twice->second) + " is given twice in the same direction");
}

double checkedSizeAt(const SizeField& field, const SurfacePoint& point) {
  const double size = field.sizeAt(point);
  if (!(size > 0) || !std::isfinite(size))
    throw InputError("size field: the wanted length at " + textOf(point.position) + " is " +
                     textOf(size) + "; it must be a positive number");
  return size;
}

namespace {

struct Extent {
  Box3 box{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
  double lengthSum = 0;
  std::size_t edges = 0;
};

Extent extentOf(const FrontInput& input) {
  Extent extent;
  const auto include = [&](const Point3& p) {
    Box3& box = extent.box;
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  };
  for (const auto& loop : input.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      include(loop[i].point.position);
      extent.lengthSum +=
          distance(loop[i].point.position, loop[(i + 1) % loop.size()].point.position);
      ++extent.edges;
    }
  }
  return extent;
}

/// A region whose whole boundary lies in one plane, with one normal.
bool isFlat(const FrontInput& input, double diagonal) {
  constexpr double kRounding = 1e-9;
  const SurfacePoint& first = input.loops[0][0].point;
  if (first.normal == Point3{}) return false;
  for (const auto& loop : input.loops)
    for (const BoundaryCorner& corner : loop)
      if (distance(corner.point.normal, first.normal) > kRounding ||
          std::abs(dot(corner.point.position - first.position, first.normal)) >
              kRounding * diagonal)
        return false;
  return true;
}

double flatArea(const FrontInput& input) {
  const SurfacePoint& first = input.loops[0][0].point;
  double area = 0;
  for (const auto& loop : input.loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      area += 0.5 *
              dot(first.normal, cross(loop[i].point.position - first.position,
                                      loop[(i + 1) % loop.size()].point.position - first.position));
  return area;
}

}  // namespace

std::optional<Box3> limitsOfFlatRegion(const FrontInput& input) {
  const Extent extent = extentOf(input);
  if (extent.edges == 0) return std::nullopt;
  const double diagonal = distance(extent.box.low, extent.box.high);
  if (!isFlat(input, diagonal)) return std::nullopt;
  if (!(flatArea(input) > 1e-15 * diagonal * diagonal))
    throw InputError(
        "boundary: its loops bound no area on their left, seen against the normals; reverse the "
        "loops that run the wrong way");
  const Point3 margin{diagonal, diagonal, diagonal};
  return Box3{extent.box.low - margin, extent.box.high + margin};
}

FrontIndex makeIndex(const FrontInput& input) {
  const Extent extent = extentOf(input);
  if (extent.edges == 0) return FrontIndex({}, 1);
  return FrontIndex(extent.box, extent.lengthSum / static_cast<double>(extent.edges));
}

}  // namespace af2
