// Whole rows: the front is walked edge after edge around a loop, then around the next.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "engine/front/front.h"
#include "engine/rule/front_order.h"

namespace af2 {

/// The queue of RowFrontOrder. Loops take turns: the next row is that of the edge that has been
/// waiting longest. It has all the waiting edges of that loop, as they follow each other; edges
/// that join the front meanwhile wait for a later row. What was refused is walked again, one level
/// higher, for as long as the row gets on; then it waits, too.
class RowWalk {
 public:
  explicit RowWalk(RowStart start) : start_(start) {}

  void push(const Front& front, PlaceId id);
  /// Takes out the next edge; none if there is none left.
  PlaceId pop(const Front& front);

 private:
  /// An edge, for as long as it is on the front: places are used again, ages are not.
  struct Edge {
    PlaceId place;
    std::uint32_t age;
  };

  bool isWaiting(const Front& front, const Edge& edge) const;
  std::size_t waitingInRow(const Front& front) const;
  bool beginRow(const Front& front);
  void rotateToStart(const Front& front);

  RowStart start_;
  std::deque<Edge> queue_;                 // as they were pushed; also those no longer waiting
  std::vector<std::uint64_t> waitingAge_;  // by place: age of the edge that waits there, plus 1
  std::vector<Edge> row_;
  std::size_t at_ = 0;          // in row_
  std::size_t passLength_ = 0;  // edges to be walked in this pass
};

}  // namespace af2
