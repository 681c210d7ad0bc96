// The front: directed loops around the unmeshed region, stored in flat arrays.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/ids.h"
#include "engine/base/point.h"
#include "engine/front/front_loops.h"
#include "engine/mesh/front_input.h"

namespace af2 {

/// One corner of the front and the edge that leaves it. A vertex can have several places.
struct alignas(64) Place {
  SurfacePoint point;
  double size = 0;  ///< wanted edge length at the vertex
  VertexId vertex;
  PlaceId next, previous;  ///< the place itself for an isolated vertex
  std::int32_t level = 0;  ///< quality level of the edge; 0: the place is not in use
  std::int32_t layer = 0;  ///< layers of elements between the vertex and the boundary
  /// Sequence number of the edge: increases with each edge that joins the front.
  std::uint32_t age = 0;
  /// How many elements the vertex wants here; 0: as many as its free angle says.
  std::int8_t ownCount = 0;
};

/// A vertex on the walk that replaces a base edge.
struct WalkVertex {
  /// The place of a front vertex, which the walk splits into two places. None for a new vertex, and
  /// for a vertex where the walk has elements on both sides.
  PlaceId existing;
  VertexId vertex;
  SurfacePoint point;
  double size = 0;
  std::int32_t layer = 0;
};

class Front {
 public:
  /// What `replace` changed.
  struct Change {
    /// Places whose edge is new; includes the base's place if its edge is new.
    std::vector<PlaceId> added;
    std::vector<PlaceId> removed;  ///< places that left the front, or whose old edge did
  };

  /// Level of a place that no edge leaves: an isolated vertex or the end of an open chain.
  static constexpr std::int32_t kNoEdge = -1;

  /// Returns the first of the new places, which have consecutive ids.
  PlaceId addLoop(std::span<const BoundaryCorner> corners, std::span<const double> sizes);
  /// Adds part of a loop whose rest is unknown, for trying rules. `replace` must not be used on it.
  PlaceId addOpenChain(std::span<const BoundaryCorner> corners, std::span<const double> sizes);
  PlaceId addIsolated(const BoundaryCorner& corner, double size);
  /// Relinks the edges where loops touch in a vertex, so that each free sector there is bounded by
  /// an edge and its successor. The input may give such loops separately or as one walk.
  void untangle();
  /// From now on keeps track of the loops and their colours.
  void keepLoops() { loops_.number(*this); }
  /// Of a front that is shown in part; see `FrontLoops::joinChains`.
  void joinChains(std::span<const std::pair<PlaceId, bool>> colours) {
    loops_.joinChains(*this, colours);
  }
  /// Numbered only after `keepLoops`.
  const FrontLoops& loops() const { return loops_; }

  /// Replaces the edge that leaves `base` by the path base -> walk... -> next(base).
  ///
  /// At each existing vertex of the walk, the vertex's two places exchange their predecessors,
  /// which splits a loop or joins two. Loops of two opposite edges cancel. `change` is overwritten.
  /// Removed places keep their contents until `release`, so that callers can still report them.
  void replace(PlaceId base, std::span<const WalkVertex> walk, Change& change);

  /// Removes two edges first -> middle -> last, whose far ends have become one vertex. The place
  /// `last` stays. The loop must have more than four edges. `change` is as for `replace`.
  void weld(PlaceId first, PlaceId last, VertexId vertex, const SurfacePoint& point,
            Change& change);

  /// Gives removed places back for reuse.
  void release(const Change& change);

  const Place& operator[](PlaceId id) const { return places_[id.value]; }
  Place& operator[](PlaceId id) { return places_[id.value]; }
  PlaceId next(PlaceId id) const { return places_[id.value].next; }
  PlaceId previous(PlaceId id) const { return places_[id.value].previous; }
  bool isUsed(PlaceId id) const { return places_[id.value].level != 0; }
  /// Whether an edge leaves the place; whether an edge arrives there.
  bool hasEdge(PlaceId id) const { return places_[id.value].level > 0; }
  bool hasEdgeBefore(PlaceId id) const { return hasEdge(previous(id)); }
  bool isIsolated(PlaceId id) const { return places_[id.value].next == id; }

  /// Number of front edges; number of isolated vertices.
  std::size_t edgeCount() const { return edgeCount_; }
  std::size_t isolatedCount() const { return isolatedCount_; }
  bool isEmpty() const { return edgeCount_ == 0; }
  /// Vertices with lower ids were given and never move.
  std::size_t fixedCount() const { return fixedCount_; }
  void fix(std::size_t count) { fixedCount_ = count; }
  std::size_t capacity() const { return places_.size(); }

  void raiseLevel(PlaceId id) { ++places_[id.value].level; }
  double edgeLength(PlaceId id) const {
    return distance((*this)[id].point.position, (*this)[next(id)].point.position);
  }
  /// Free angle at a place, radians in (0, 2 pi], seen along the vertex normal.
  double turn(PlaceId id) const;
  /// The same as a number in (0, 4] that grows with the angle: see `sweepOf`.
  double sweep(PlaceId id) const;
  /// Number of edges in the loop of a place.
  int loopSize(PlaceId id) const;

 private:
  PlaceId take();
  void link(PlaceId from, PlaceId to) {
    places_[from.value].next = to;
    places_[to.value].previous = from;
  }
  template <class Measure>
  double measureTurn(PlaceId id, const Measure& measure) const;
  void exchangePredecessors(PlaceId p, PlaceId q);
  /// For each place of one vertex, the place whose edge arrives at the end of its free sector.
  /// Empty if the edges there do not pair up.
  std::vector<PlaceId> freeNeighbors(std::span<const PlaceId> places) const;
  void cancelOppositeEdges(PlaceId id, Change& change);

  std::vector<Place> places_;
  std::vector<PlaceId> free_;
  std::vector<PlaceId> touched_;
  FrontLoops loops_;
  std::size_t edgeCount_ = 0, isolatedCount_ = 0, fixedCount_ = 0;
  std::uint32_t age_ = 0;
};

}  // namespace af2
