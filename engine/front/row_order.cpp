#include "engine/front/row_order.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include "engine/front/front.h"

namespace af2 {
namespace {

class RowWalk final : public AF2EdgeQueue {
 public:
  explicit RowWalk(RowStart start) : start_(start) {}

  void push(const Front& front, PlaceId id) override;
  PlaceId pop(const Front& front) override;

 private:
  /// Identifies an edge while it is on the front: a place is reused later, an age is not.
  struct Edge {
    PlaceId place;
    std::uint32_t age;
  };

  bool isWaiting(const Front& front, const Edge& edge) const;
  std::size_t waitingInRow(const Front& front) const;
  bool beginRow(const Front& front);
  void rotateToStart(const Front& front);

  RowStart start_;
  std::deque<Edge> queue_;  // in order of insertion; includes edges that no longer wait
  // By place: age of the waiting edge, plus 1; 0: none waits.
  std::vector<std::uint64_t> waitingAge_;
  std::vector<Edge> row_;
  std::size_t at_ = 0;          // index in row_
  std::size_t passLength_ = 0;  // edges to visit in this pass
};

void RowWalk::push(const Front& front, PlaceId id) {
  if (waitingAge_.size() <= id.value) waitingAge_.resize(front.capacity(), 0);
  const std::uint32_t age = front[id].age;
  waitingAge_[id.value] = std::uint64_t{age} + 1;
  queue_.push_back({id, age});
}

PlaceId RowWalk::pop(const Front& front) {
  for (;;) {
    while (at_ < row_.size()) {
      const Edge edge = row_[at_++];
      if (!isWaiting(front, edge)) continue;
      waitingAge_[edge.place.value] = 0;
      return edge.place;
    }
    // The pass is complete. Refused edges were inserted again, one level higher, and wait.
    const std::size_t left = waitingInRow(front);
    const bool getsOn = 0 < left && left < passLength_;
    if (!getsOn && !beginRow(front)) return {};
    passLength_ = waitingInRow(front);
    at_ = 0;
  }
}

bool RowWalk::isWaiting(const Front& front, const Edge& edge) const {
  return waitingAge_[edge.place.value] == std::uint64_t{edge.age} + 1 &&
         front.hasEdge(edge.place) && front[edge.place].age == edge.age;
}

std::size_t RowWalk::waitingInRow(const Front& front) const {
  return static_cast<std::size_t>(std::count_if(
      row_.begin(), row_.end(), [&](const Edge& edge) { return isWaiting(front, edge); }));
}

bool RowWalk::beginRow(const Front& front) {
  row_.clear();
  while (!queue_.empty() && !isWaiting(front, queue_.front())) queue_.pop_front();
  if (queue_.empty()) return false;
  const PlaceId first = queue_.front().place;
  PlaceId id = first;
  do {
    const Edge edge{id, front[id].age};
    if (id.value < waitingAge_.size() && isWaiting(front, edge)) row_.push_back(edge);
    id = front.next(id);
  } while (id != first);
  rotateToStart(front);
  return true;
}

/// Among corners with equal angles, such as those of a rectangle, takes the one at the oldest edge:
/// rounding must not decide.
void RowWalk::rotateToStart(const Front& front) {
  if (start_ == RowStart::Oldest) return;
  constexpr double kSame = 1e-9;  // radians
  auto start = row_.begin();
  double smallest = front.turn(start->place);
  for (auto it = row_.begin() + 1; it != row_.end(); ++it) {
    const double turn = front.turn(it->place);
    if (turn >= smallest - kSame) continue;
    smallest = turn;
    start = it;
  }
  std::rotate(row_.begin(), start, row_.end());
}

}  // namespace

std::unique_ptr<AF2EdgeQueue> RowFrontOrder::makeQueue() const {
  return std::make_unique<RowWalk>(start_);
}

}  // namespace af2
