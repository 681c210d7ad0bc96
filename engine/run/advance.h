// The state of an advance, for acts beside the steps of rules.
// Not installed.
#pragma once

#include <span>
#include <vector>

#include "engine/front/front.h"
#include "engine/front/front_index.h"
#include "engine/front/front_queue.h"
#include "engine/mesh/mesh.h"
#include "engine/run/vertex_elements.h"
#include "engine/step/neighborhood.h"
#include "engine/surface/local_transform.h"

namespace af2 {

struct Advance {
  Front& front;
  FrontIndex& index;
  FrontQueue& queue;
  Mesh& mesh;
  VertexElements& elements;
  const AF2LocalTransformMaker& maker;

  bool isFixed(VertexId v) const { return v.value < front.fixedCount(); }
  const Point3& positionOf(VertexId v) const { return mesh.vertices[v.value].position; }

  /// All places of the vertex of a place, in the order of their ids.
  std::vector<PlaceId> placesOf(PlaceId place) const;
  /// Front edges that may come closer to a place than `reach`, in the order of their ids.
  std::vector<PlaceId> edgesNear(PlaceId place, double reach) const;
  /// Moves a vertex with all its places.
  void move(VertexId v, std::span<const PlaceId> places, const SurfacePoint& to);
  /// The chart of the edge that leaves a place, in units of the wanted length there.
  StepChart chartAt(PlaceId place, ChartSlot& slot) const;
};

/// The scaled Jacobian of an element in a chart, with one of its vertices elsewhere.
double scaledJacobianIn(const StepChart& chart, const Mesh& mesh, const Element& element,
                        VertexId moved, Point2 to);

}  // namespace af2
