// Fronts in the plane z = 0 for tests, and what is on them as plain lists.
#pragma once

#include <algorithm>
#include <vector>

#include "engine/front/front.h"
#include "engine/front/front_queue.h"
#include "tests/support/flat_surface.h"

namespace af2::testing {

using VertexLoop = std::vector<std::size_t>;

/// Adds a closed polygon whose vertices are numbered from `firstVertex` on.
inline PlaceId addPolygon(Front& front, const std::vector<Point2>& polygon,
                          std::size_t firstVertex = 0, double size = 1) {
  std::vector<BoundaryCorner> corners;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    corners.push_back(flatCorner(firstVertex + i, polygon[i]));
  return front.addLoop(corners, std::vector<double>(corners.size(), size));
}

inline WalkVertex existingVertex(const Front& front, PlaceId id) {
  return {id, front[id].vertex, front[id].point, front[id].size, front[id].layer};
}

inline WalkVertex newVertex(std::size_t id, Point2 p, std::int32_t layer = 1) {
  return {PlaceId(), VertexId(id), flatCorner(id, p).point, 1, layer};
}

/// The loops of a front as lists of vertices, each from its smallest turn on, in order.
inline std::vector<VertexLoop> loopsOf(const Front& front) {
  std::vector<VertexLoop> loops;
  std::vector<bool> isSeen(front.capacity(), false);
  for (std::size_t i = 0; i < front.capacity(); ++i) {
    if (isSeen[i] || !front.hasEdge(PlaceId(i))) continue;
    VertexLoop loop;
    for (PlaceId p(i); !isSeen[p.value]; p = front.next(p)) {
      isSeen[p.value] = true;
      loop.push_back(front[p].vertex.value);
    }
    VertexLoop best = loop;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      std::rotate(loop.begin(), loop.begin() + 1, loop.end());
      best = std::min(best, loop);
    }
    loops.push_back(best);
  }
  std::sort(loops.begin(), loops.end());
  return loops;
}

/// The place of a vertex; the first one if it has several.
inline PlaceId placeOf(const Front& front, std::size_t vertex) {
  for (std::size_t i = 0; i < front.capacity(); ++i)
    if (front.isUsed(PlaceId(i)) && front[PlaceId(i)].vertex == VertexId(vertex)) return PlaceId(i);
  return {};
}

inline void pushAll(FrontQueue& queue, const Front& front) {
  for (std::size_t i = 0; i < front.capacity(); ++i)
    if (front.hasEdge(PlaceId(i))) queue.push(front, PlaceId(i));
}

}  // namespace af2::testing
