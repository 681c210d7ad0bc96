// An order of the front: whole rows, edge after edge around a loop, then around the next.
#pragma once

#include <memory>

#include "engine/base/export.h"
#include "engine/rule/front_order.h"

namespace af2 {

/// Where a row begins on its loop: at the vertex with the smallest free angle, or at the oldest
/// edge.
enum class RowStart { SmallestTurn, Oldest };

/// Loops take turns: the next row is that of the edge that has been waiting longest. It has all the
/// waiting edges of that loop, as they follow each other; edges that join the front meanwhile wait
/// for a later row. What was refused is walked again, one level higher, for as long as the row gets
/// on; then it waits, too.
class AF2_EXPORT RowFrontOrder final : public AF2FrontOrder {
 public:
  explicit RowFrontOrder(RowStart start) : start_(start) {}
  std::unique_ptr<AF2EdgeQueue> makeQueue() const override;

 private:
  RowStart start_;
};

}  // namespace af2
