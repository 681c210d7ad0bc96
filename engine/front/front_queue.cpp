#include "engine/front/front_queue.h"

#include <algorithm>

namespace af2 {
namespace {

FrontEdgeFacts factsOf(const Front& front, PlaceId id, bool needsTurns) {
  const Place& a = front[id];
  const Place& b = front[a.next];
  FrontEdgeFacts facts{a.level, a.layer, b.layer, 2 * front.edgeLength(id) / (a.size + b.size)};
  if (needsTurns) {
    facts.turnA = front.turn(id);
    facts.turnB = front.turn(a.next);
  }
  return facts;
}

}  // namespace

FrontQueue::FrontQueue(const AF2FrontOrder& order)
    : order_(order), layered_(order.layered()), own_(order.makeQueue()) {}

void FrontQueue::push(const Front& front, PlaceId id) {
  const Entry entry{id, front[id].age};
  if (layered_) {
    const auto key = static_cast<std::size_t>(
        layered_->wholeKey(front[id].level, front[id].layer, front[front.next(id)].layer));
    if (key >= buckets_.size()) buckets_.resize(key + 16);
    buckets_[key].entries.push_back(entry);
    lowest_ = std::min(lowest_, key);
    return;
  }
  if (own_) return own_->push(front, id);
  const FrontEdgeFacts facts = factsOf(front, id, order_.needsTurns());
  KeyedEntry keyed{{}, turn_++, entry};
  for (int i = 0; i < order_.keyCount(); ++i) keyed.keys.push_back(order_.key(i, facts));
  heap_.push(std::move(keyed));
}

PlaceId FrontQueue::pop(const Front& front) {
  if (own_) return own_->pop(front);
  for (; lowest_ < buckets_.size(); ++lowest_) {
    Bucket& bucket = buckets_[lowest_];
    while (bucket.head < bucket.entries.size()) {
      const Entry entry = bucket.entries[bucket.head++];
      if (isCurrent(front, entry)) return entry.place;
    }
    bucket.entries.clear();
    bucket.head = 0;
  }
  while (!heap_.empty()) {
    const Entry entry = heap_.top().entry;
    heap_.pop();
    if (isCurrent(front, entry)) return entry.place;
  }
  return {};
}

}  // namespace af2
