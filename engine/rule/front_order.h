// Which front edge is advanced next, as the rule set defines it.
#pragma once

#include <memory>

#include "engine/base/export.h"
#include "engine/base/ids.h"

namespace af2 {

/// What the order may depend on: one front edge a -> b when it enters the queue or its level rises.
struct FrontEdgeFacts {
  int level = 1;
  int layerA = 0, layerB = 0;     ///< layers of elements between the vertex and the boundary
  double length = 1;              ///< in units of the wanted length
  double turnA = 0, turnB = 0;    ///< free angles at the ends, radians in (0, 2 pi]
  double sweepA = 0, sweepB = 0;  ///< the same free angles as `sweepOf` measures them, in (0, 4]
  /// How many elements the ends want; 0: as many as their free angles say.
  int ownCountA = 0, ownCountB = 0;
};

class Front;
class LayeredFrontOrder;

/// The edges of the front that wait to be advanced, for an order that sort keys cannot express.
class AF2_EXPORT AF2EdgeQueue {
 public:
  virtual ~AF2EdgeQueue() = default;
  /// Inserts the edge that leaves a place: it has joined the front, or its level has risen.
  virtual void push(const Front& front, PlaceId place) = 0;
  /// Removes and returns the next edge, none if the queue is empty. Edges may leave the front while
  /// they wait; those are skipped.
  virtual PlaceId pop(const Front& front) = 0;
};

/// Which of the waiting edges is next. The same front must give the same answer, so the order must
/// not depend on addresses, hash tables or clocks.
///
/// Most orders sort by keys: the smallest key first, compared lexicographically. Ties, and orders
/// without keys, go to the edge that entered first. A key is computed when an edge enters the front
/// and when its level rises; keys that use turns or sweeps also when an end of the edge gets
/// another neighbour. An order that keys cannot express provides a queue of its own.
class AF2_EXPORT AF2FrontOrder {
 public:
  virtual ~AF2FrontOrder() = default;
  virtual int keyCount() const { return 0; }
  virtual double key(int /*index*/, const FrontEdgeFacts&) const { return 0; }
  /// Whether `key` uses the turns, which cost more to compute than the rest.
  virtual bool needsTurns() const { return true; }
  /// Whether `key` uses the sweeps and own counts.
  virtual bool needsSweeps() const { return needsTurns(); }
  /// A queue that keeps this order and replaces the one that sorts by keys; null: there is none.
  virtual std::unique_ptr<AF2EdgeQueue> makeQueue() const { return nullptr; }
  /// The fast form of the same order; null: there is none.
  virtual const LayeredFrontOrder* layered() const { return nullptr; }
};

/// The fast form: one key, level * l + layerA * a + layerB * b with small whole coefficients >= 0.
class AF2_EXPORT LayeredFrontOrder final : public AF2FrontOrder {
 public:
  LayeredFrontOrder(int level, int layerA, int layerB);
  int keyCount() const override { return 1; }
  double key(int, const FrontEdgeFacts& edge) const override {
    return wholeKey(edge.level, edge.layerA, edge.layerB);
  }
  bool needsTurns() const override { return false; }
  const LayeredFrontOrder* layered() const override { return this; }
  int wholeKey(int level, int layerA, int layerB) const {
    return level_ * level + layerA_ * layerA + layerB_ * layerB;
  }

 private:
  int level_, layerA_, layerB_;
};

}  // namespace af2
