#include "geometry/layers/layer_ends.h"

#include <algorithm>
#include <cmath>

#include "engine/base/elementary.h"

namespace af2::geometry {
namespace {

double lengthOf(const DividedEdge& edge, const DividedEdges& divided) {
  double length = 0;
  for (std::size_t i = 1; i < edge.points.size(); ++i)
    length += distance(divided.points[edge.points[i - 1]], divided.points[edge.points[i]]);
  return length;
}

/// The lengths along a boundary that turns by `turn` from the edge with the layers.
std::vector<double> lengthsAlong(const LayerHeights& heights, double turn) {
  std::vector<double> lengths = heights.tops();
  lengths.erase(lengths.begin());
  for (double& length : lengths) length /= sine(turn);
  return lengths;
}

}  // namespace

void addLayerEnds(const FaceBoundary& boundary, const EdgeLayers& layers,
                  const DividedEdges& divided, LayerEnds& ends) {
  const auto edges = edgesOfSegments(boundary, divided);
  for (const LayerRun& run : layerRuns(boundary, layers, edges)) {
    if (run.isClosed) continue;
    const LoopView loop(boundary.input.loops[run.loop]);
    const auto add = [&](std::size_t corner, std::size_t segment) {
      const double turn = loop.turnAt(corner);
      const int edge = edges[run.loop][segment % loop.size()];
      if (edge == 0 || layers.contains(edge) || !mayEndOnBoundary(turn)) return;
      const auto& points = divided.edges[static_cast<std::size_t>(edge) - 1].points;
      const std::size_t beside = segment % loop.size() == corner ? corner + 1 : segment;
      const auto pointAt = [&](std::size_t c) { return boundary.points[loop.at(c).vertex.value]; };
      const bool isStart = points[0] == pointAt(corner) && points[1] == pointAt(beside);
      const bool isEnd =
          points.back() == pointAt(corner) && points[points.size() - 2] == pointAt(beside);
      if (!isStart && !isEnd) return;  // the layers end within the edge
      ends.try_emplace({edge, isStart}, lengthsAlong(run.heights, turn));
    };
    add(run.first % loop.size(), loop.before(run.first));
    add((run.first + run.segments) % loop.size(), run.first + run.segments);
  }
}

void fitLayerEnds(const DividedEdges& divided, LayerEnds& ends) {
  constexpr double kShare = 0.8;  // of the edge, or of its half
  for (auto& [end, lengths] : ends) {
    const DividedEdge& edge = divided.edges[static_cast<std::size_t>(end.first) - 1];
    const bool hasOther = ends.contains({end.first, !end.second});
    const double room = kShare * lengthOf(edge, divided) * (hasOther ? 0.5 : 1);
    const double share = std::clamp(room / lengths.back(), kThinnest, 1.0);
    for (double& length : lengths) length *= share;
    std::erase_if(lengths, [&](double length) { return length > room; });
  }
  std::erase_if(ends, [](const auto& end) { return end.second.empty(); });
}

}  // namespace af2::geometry
