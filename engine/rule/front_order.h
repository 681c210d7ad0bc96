// Which front edge is advanced next, as a rule set says it.
#pragma once

#include <vector>

namespace af2 {

/// What the order may depend on: one front edge a -> b when it enters the queue or its level rises.
struct FrontEdgeFacts {
  int level = 1;
  int layerA = 0, layerB = 0;   ///< layers of elements between the vertex and the boundary
  double length = 1;            ///< in units of the wanted length
  double turnA = 0, turnB = 0;  ///< free angles at the ends, radians in (0, 2 pi]
};

/// Smallest key first, compared lexicographically; equal keys: the edge that entered first.
///
/// A key is worked out when an edge enters the front and when its level rises. Derive from this for
/// an order that the fast form below cannot say.
class AF2FrontOrder {
 public:
  virtual ~AF2FrontOrder() = default;
  virtual int keyCount() const = 0;
  virtual double key(int index, const FrontEdgeFacts& edge) const = 0;
  /// Whether `key` looks at the turns, which cost more than the rest.
  virtual bool needsTurns() const { return true; }
};

/// The fast form: one key, level * l + layerA * a + layerB * b with small whole coefficients >= 0.
class LayeredFrontOrder final : public AF2FrontOrder {
 public:
  LayeredFrontOrder(int level, int layerA, int layerB);
  int keyCount() const override { return 1; }
  double key(int, const FrontEdgeFacts& edge) const override {
    return wholeKey(edge.level, edge.layerA, edge.layerB);
  }
  bool needsTurns() const override { return false; }
  int wholeKey(int level, int layerA, int layerB) const {
    return level_ * level + layerA_ * layerA + layerB_ * layerB;
  }

 private:
  int level_, layerA_, layerB_;
};

/// Where a row begins on its loop: at the vertex with the smallest free angle, or at the oldest
/// edge.
enum class RowStart { SmallestTurn, Oldest };

/// Whole rows instead of keys: from the start of a row edge after edge around the loop, then the
/// next row. Edges that join the front belong to a later row.
class RowFrontOrder final : public AF2FrontOrder {
 public:
  explicit RowFrontOrder(RowStart start) : start_(start) {}
  RowStart start() const { return start_; }
  int keyCount() const override { return 0; }
  double key(int, const FrontEdgeFacts&) const override { return 0; }
  bool needsTurns() const override { return false; }

 private:
  RowStart start_;
};

}  // namespace af2
