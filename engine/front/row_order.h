// A front order that works in rows: edge after edge around one loop, then around the next.
#pragma once

#include <memory>

#include "engine/base/export.h"
#include "engine/rule/front_order.h"

namespace af2 {

/// Where a row begins on its loop: at the vertex with the smallest free angle, or at the oldest
/// edge.
enum class RowStart { SmallestTurn, Oldest };

/// Loops take turns: the next row belongs to the loop of the edge that has waited longest. It
/// consists of all waiting edges of that loop, in loop order; edges that join the front meanwhile
/// wait for a later row. Refused edges are visited again, one level higher, as long as each pass
/// takes some edges; then they wait, too.
class AF2_EXPORT RowFrontOrder final : public AF2FrontOrder {
 public:
  explicit RowFrontOrder(RowStart start) : start_(start) {}
  std::unique_ptr<AF2EdgeQueue> makeQueue() const override;

 private:
  RowStart start_;
};

}  // namespace af2
