#include "geometry/layers/layer_runs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "engine/base/elementary.h"

namespace af2::geometry {

Point3 LoopView::direction(std::size_t from, std::size_t to, std::size_t in) const {
  const Point3& normal = at(in).point.normal;
  const Point3 along = at(to).point.position - at(from).point.position;
  return unit(along - dot(along, normal) * normal);
}

double LoopView::turnAt(std::size_t corner) const {
  if (at(before(corner)).vertex == at(corner + 1).vertex) return -std::numbers::pi;
  const Point3 in = directionIn(corner), out = directionOut(corner);
  return angleOf({dot(in, out), dot(cross(in, out), at(corner).point.normal)});
}

std::vector<std::vector<int>> edgesOfSegments(const FaceBoundary& boundary,
                                              const DividedEdges& divided) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const SegmentUse& use : boundary.uses) {
    const auto& points = divided.edges[static_cast<std::size_t>(use.edge) - 1].points;
    edges[std::minmax({points[use.segment], points[use.segment + 1]})] = use.edge;
  }
  std::vector<std::vector<int>> found;
  for (const auto& loop : boundary.input.loops) {
    std::vector<int>& own = found.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const VertexId from = loop[i].vertex, to = loop[(i + 1) % loop.size()].vertex;
      const std::size_t count = boundary.points.size();
      const auto edge =
          from.value < count && to.value < count
              ? edges.find(std::minmax({boundary.points[from.value], boundary.points[to.value]}))
              : edges.end();
      own.push_back(edge == edges.end() ? 0 : edge->second);
    }
  }
  return found;
}

namespace {

/// The runs of one loop, given the layers of each segment.
void addRuns(std::size_t loop, const LoopView& corners,
             const std::vector<const LayerHeights*>& layers, std::vector<LayerRun>& runs) {
  const std::size_t count = layers.size();
  const auto goesOn = [&](std::size_t corner) {  // from the segment before it to the one behind it
    const LayerHeights *before = layers[corners.before(corner)], *behind = layers[corner];
    return before && behind && *before == *behind && length(corners.at(corner).point.normal) > 0;
  };
  std::size_t start = 0;
  while (start < count && goesOn(start)) ++start;
  if (start == count) {
    runs.push_back({loop, 0, count, true, *layers.front()});
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t segment = (start + i) % count;
    if (!layers[segment]) continue;
    if (goesOn(segment) && i > 0)
      ++runs.back().segments;
    else
      runs.push_back({loop, segment, 1, false, *layers[segment]});
  }
}

}  // namespace

std::vector<LayerRun> layerRuns(const FaceBoundary& boundary, const EdgeLayers& layers,
                                const std::vector<std::vector<int>>& edges) {
  std::vector<LayerRun> runs;
  for (std::size_t l = 0; l < edges.size(); ++l) {
    std::vector<const LayerHeights*> ofSegments;
    for (const int edge : edges[l]) {
      const auto found = layers.find(edge);
      ofSegments.push_back(found == layers.end() ? nullptr : &found->second);
    }
    if (std::ranges::any_of(ofSegments, [](const LayerHeights* own) { return own != nullptr; }))
      addRuns(l, LoopView(boundary.input.loops[l]), ofSegments, runs);
  }
  return runs;
}

bool mayEndOnBoundary(double turn) {
  constexpr double kDegree = std::numbers::pi / 180;
  return turn >= 45 * kDegree && turn <= 155 * kDegree;
}

}  // namespace af2::geometry
