#include "geometry/layers/leave_out_layers.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "geometry/layers/layer_columns.h"
#include "geometry/layers/layer_limits.h"
#include "geometry/layers/layer_runs.h"

namespace af2::geometry {
namespace {

/// Vertices that others refer to by their places in the loops.
std::set<VertexId> referredTo(const FaceBoundary& boundary) {
  std::set<VertexId> vertices;
  for (const FaceBoundary::Fan& fan : boundary.fans)
    vertices.insert(fan.rim.begin(), fan.rim.end());
  for (const BoundaryCorner& corner : boundary.input.isolated) vertices.insert(corner.vertex);
  return vertices;
}

/// Makes elements of columns. New vertices get ids above those of the boundary.
class LayerMaker {
 public:
  LayerMaker(const LayerGrid& grid, LayerSteps steps, FaceBoundary& boundary)
      : grid_(grid), steps_(steps), boundary_(boundary) {}

  void make() {
    for (const auto& loop : boundary_.input.loops)
      for (const BoundaryCorner& corner : loop) places_.try_emplace(corner.vertex, corner.point);
    for (const BoundaryCorner& corner : boundary_.input.isolated)
      places_.try_emplace(corner.vertex, corner.point);
    next_ = boundary_.input.vertexCount;
    for (const LayerColumn& column : grid_.columns) ids_.push_back(idsOf(column));
    before_.assign(grid_.columns.size(), kNone);
    behind_.assign(grid_.columns.size(), kNone);
    for (const LayerCell& cell : grid_.cells) {
      before_[cell.right] = cell.left;
      behind_[cell.left] = cell.right;
    }
    for (const LayerCell& cell : grid_.cells)
      if (!isFan(cell)) addCell(cell);
    addFans();
    for (std::size_t l = 0; l < boundary_.input.loops.size(); ++l) replaceLoop(l);
    renumber();
    measure();
  }

 private:
  bool isFan(const LayerCell& cell) const {
    const LayerColumn &left = grid_.columns[cell.left], &right = grid_.columns[cell.right];
    return left.fan >= 0 && left.fan == right.fan && left.corner == right.corner;
  }

  /// Of the points of a column up to its top. All columns above a corner begin at its vertex.
  std::vector<VertexId> idsOf(const LayerColumn& column) {
    const auto& loop = boundary_.input.loops[column.loop];
    std::vector<VertexId> ids{loop[column.corner].vertex};
    for (std::size_t k = 1; k <= column.levels; ++k) {
      if (!column.corners.empty()) {
        ids.push_back(loop[column.corners[k]].vertex);
        continue;
      }
      ids.emplace_back(next_++);
      places_[ids.back()] = column.points[k];
    }
    return ids;
  }

  void add(std::initializer_list<VertexId> corners) {
    Element element;
    std::ranges::copy(corners, element.corners.begin());
    layers_.elements.push_back(element);
  }

  void addQuads(const LayerCell& cell, std::size_t from) {
    const std::vector<VertexId>&left = ids_[cell.left], &right = ids_[cell.right];
    for (std::size_t k = from; k < std::min(left.size(), right.size()); ++k)
      add({left[k - 1], right[k - 1], right[k], left[k]});
  }

  /// A triangle ends the last layer if one column has a layer more than the other.
  void addCell(const LayerCell& cell) {
    addQuads(cell, 1);
    if (steps_ == LayerSteps::Sides) return;
    const std::vector<VertexId>&left = ids_[cell.left], &right = ids_[cell.right];
    const std::size_t common = std::min(left.size(), right.size());
    if (left.size() > common) add({left[common - 1], right[common - 1], left[common]});
    if (right.size() > common) add({left[common - 1], right[common - 1], right[common]});
  }

  /// Its first layer has a quadrilateral for each two sectors.
  void addFans() {
    const std::vector<LayerCell>& cells = grid_.cells;
    for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
      if (!isFan(cells[i])) continue;
      const std::vector<VertexId>&first = ids_[cells[i].left], &middle = ids_[cells[i].right],
            &last = ids_[cells[i + 1].right];
      if (first.size() > 1) add({first[0], last[1], middle[1], first[1]});
      addQuads(cells[i], 2);
      addQuads(cells[i + 1], 2);
      ++i;
    }
  }

  /// The levels of a column through which the loop goes: its top, and before and behind it the end
  /// of the side on which the next column has a layer less.
  std::vector<std::size_t> levelsInLoop(std::size_t column) const {
    const std::size_t top = grid_.columns[column].levels;
    std::vector<std::size_t> levels{top};
    if (steps_ == LayerSteps::Triangles) return levels;
    const auto isLower = [&](std::size_t other) {
      return other != kNone && grid_.columns[other].levels < top;
    };
    if (isLower(before_[column])) levels.insert(levels.begin(), top - 1);
    if (isLower(behind_[column])) levels.push_back(top - 1);
    return levels;
  }

  /// The loop goes over the tops of columns instead of along the boundary below them.
  void replaceLoop(std::size_t index) {
    std::vector<BoundaryCorner>& loop = boundary_.input.loops[index];
    std::vector<bool> isLeftOut(loop.size(), false);
    std::map<std::size_t, std::vector<BoundaryCorner>> tops;  // by corner at the base
    for (std::size_t c = 0; c < grid_.columns.size(); ++c) {
      const LayerColumn& column = grid_.columns[c];
      if (column.loop != index) continue;
      isLeftOut[column.corner] = true;
      for (std::size_t k = 1; k < column.corners.size() && k <= column.levels; ++k)
        isLeftOut[column.corners[k]] = true;
      for (const std::size_t level : levelsInLoop(c))
        tops[column.corner].push_back({ids_[c][level], column.points[level]});
    }
    std::vector<BoundaryCorner> replaced;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (const auto found = tops.find(i); found != tops.end()) {
        for (const BoundaryCorner& corner : found->second)
          if (replaced.empty() || replaced.back().vertex != corner.vertex)
            replaced.push_back(corner);
      } else if (!isLeftOut[i]) {
        replaced.push_back(loop[i]);
      }
    }
    loop = std::move(replaced);
  }

  /// First what the loops use, then the other vertices of the boundary, then the others inside.
  void renumber() {
    const auto first = static_cast<std::uint32_t>(boundary_.points.size());
    std::vector<bool> isUsed(next_, false);
    for (const auto& loop : boundary_.input.loops)
      for (const BoundaryCorner& corner : loop) isUsed[corner.vertex.value] = true;
    for (const VertexId v : referredTo(boundary_)) isUsed[v.value] = true;
    std::vector<std::uint32_t> points;
    number(isUsed, true, 0, first, &points, nullptr);
    number(isUsed, true, first, next_, nullptr, nullptr);
    boundary_.input.vertexCount = numbered_;
    number(isUsed, false, 0, first, &layers_.points, &layers_.places);
    number(isUsed, false, first, next_, nullptr, &layers_.inside);
    boundary_.points = std::move(points);
    const auto renumber = [&](VertexId& v) { v = newIds_.at(v); };
    for (auto& loop : boundary_.input.loops)
      for (BoundaryCorner& corner : loop) renumber(corner.vertex);
    for (BoundaryCorner& corner : boundary_.input.isolated) renumber(corner.vertex);
    for (FaceBoundary::Fan& fan : boundary_.fans)
      for (VertexId& v : fan.rim) renumber(v);
    for (Element& element : layers_.elements)
      for (VertexId& v : element.corners)
        if (!v.isNone()) renumber(v);
    for (const auto& [old, place] : places_) placesByNew_[newIds_.at(old)] = place.position;
  }

  void number(const std::vector<bool>& isUsed, bool whichAre, std::size_t from, std::size_t to,
              std::vector<std::uint32_t>* points, std::vector<SurfacePoint>* places) {
    for (std::size_t i = from; i < to; ++i) {
      if (isUsed[i] != whichAre) continue;
      newIds_[VertexId(i)] = VertexId(numbered_++);
      if (points) points->push_back(boundary_.points[i]);
      if (places) places->push_back(places_.at(VertexId(i)));
    }
  }

  void measure() {
    for (const Element& element : layers_.elements) {
      const auto at = [&](std::size_t i) { return placesByNew_.at(element.corners[i]); };
      layers_.area += length(cross(at(1) - at(0), at(2) - at(0))) / 2;
      if (element.isQuad()) layers_.area += length(cross(at(2) - at(0), at(3) - at(0))) / 2;
    }
    boundary_.layers = std::move(layers_);
  }

  static constexpr std::size_t kNone = ~std::size_t{0};

  const LayerGrid& grid_;
  LayerSteps steps_;
  std::vector<std::size_t> before_, behind_;  // by column: the next ones
  FaceBoundary& boundary_;
  std::map<VertexId, SurfacePoint> places_;
  std::size_t next_ = 0, numbered_ = 0;
  std::vector<std::vector<VertexId>> ids_;  // by column
  FaceBoundary::Layers layers_;
  std::map<VertexId, VertexId> newIds_;
  std::map<VertexId, Point3> placesByNew_;
};

/// What there was room for along each edge.
std::vector<LayersAlongEdge> layersAlongEdges(const LayerGrid& grid, const FaceBoundary& boundary,
                                              const EdgeLayers& layers,
                                              const std::vector<std::vector<int>>& edges) {
  std::map<int, LayersAlongEdge> byEdge;
  for (const LayerCell& cell : grid.cells) {
    const LayerColumn &left = grid.columns[cell.left], &right = grid.columns[cell.right];
    if (left.corner == right.corner) continue;  // a fan
    const int edge = edges[left.loop][left.corner];
    LayersAlongEdge& own = byEdge[edge];
    const auto count = static_cast<std::size_t>(layers.at(edge).count);
    const std::size_t levels = std::min(left.levels, right.levels);
    const auto& loop = boundary.input.loops[left.loop];
    if (own.segments++ == 0) {
      own.edge = edge;
      own.asked = count;
      own.fewest = count + 1;
    }
    own.most = std::max(own.most, levels);
    if (levels < count) ++own.fewer;
    const double share = levels > 0 ? std::min(left.share, right.share) : 1;
    if (share < 1) ++own.thinner;
    const bool isLowest = levels < own.fewest || (levels == own.fewest && share < own.thinnest);
    own.thinnest = std::min(own.thinnest, share);
    if (!isLowest) continue;
    own.fewest = levels;
    own.place =
        0.5 * (left.points[0].position + loop[(left.corner + 1) % loop.size()].point.position);
  }
  std::vector<LayersAlongEdge> all;
  for (auto& [edge, own] : byEdge) all.push_back(own);
  return all;
}

}  // namespace

void leaveOutLayers(const ChartedSurface& surface, const PlaceInParameters& place,
                    const EdgeLayers& layers, const DividedEdges& divided, LayerSteps steps,
                    FaceBoundary& boundary) {
  const auto edges = edgesOfSegments(boundary, divided);
  const SurfaceWalk walk(surface, place);
  LayerGrid grid = layerGrid(boundary, layers, edges, referredTo(boundary), walk);
  if (grid.runs.empty()) return;
  limitLayers(boundary, walk, grid);
  std::vector<LayersAlongEdge> along = layersAlongEdges(grid, boundary, layers, edges);
  LayerMaker(grid, steps, boundary).make();
  boundary.layers->along = std::move(along);
}

}  // namespace af2::geometry
