#include "engine/front/front_queue.h"

#include <algorithm>
#include <utility>

namespace af2 {
namespace {

FrontEdgeFacts factsOf(const Front& front, PlaceId id, const AF2FrontOrder& order) {
  const Place& a = front[id];
  const Place& b = front[a.next];
  FrontEdgeFacts facts{a.level, a.layer, b.layer, 2 * front.edgeLength(id) / (a.size + b.size)};
  if (order.needsTurns()) {
    facts.turnA = front.turn(id);
    facts.turnB = front.turn(a.next);
  }
  if (!order.needsSweeps()) return facts;
  facts.sweepA = front.sweep(id);
  facts.sweepB = front.sweep(a.next);
  facts.ownCountA = a.ownCount;
  facts.ownCountB = b.ownCount;
  return facts;
}

}  // namespace

/// std::priority_queue takes the largest first.
bool FrontQueue::KeyedEntry::operator<(const KeyedEntry& other) const {
  if (key != other.key) return key > other.key;
  if (moreKeys != other.moreKeys) return moreKeys > other.moreKeys;
  return turn > other.turn;
}

FrontQueue::FrontQueue(const AF2FrontOrder& order)
    : order_(order),
      layered_(order.layered()),
      own_(order.makeQueue()),
      isRenewed_(!layered_ && !own_ && (order.needsTurns() || order.needsSweeps())) {}

void FrontQueue::push(const Front& front, PlaceId id) {
  if (layered_) {
    const auto key = static_cast<std::size_t>(
        layered_->wholeKey(front[id].level, front[id].layer, front[front.next(id)].layer));
    if (key >= buckets_.size()) buckets_.resize(key + 16);
    buckets_[key].entries.push_back({id, front[id].age});
    lowest_ = std::min(lowest_, key);
    return;
  }
  if (own_) return own_->push(front, id);
  KeyedEntry entry = keyedEntry(front, id, turn_++);
  entry.version = ++version_;
  if (waiting_.size() <= id.value) waiting_.resize(front.capacity());
  Waiting& waiting = waiting_[id.value];
  if (waiting.age != entry.entry.age) waiting = {entry.entry.age, 0, 0, entry.version, 0};
  ++waiting.count;
  waiting.turn = entry.turn;
  waiting.key = entry.key;
  heap_.push(std::move(entry));
}

FrontQueue::KeyedEntry FrontQueue::keyedEntry(const Front& front, PlaceId id,
                                              std::uint64_t turn) const {
  const FrontEdgeFacts facts = factsOf(front, id, order_);
  KeyedEntry keyed{0, {}, turn, 0, {id, front[id].age}};
  if (order_.keyCount() > 0) keyed.key = order_.key(0, facts);
  for (int i = 1; i < order_.keyCount(); ++i) keyed.moreKeys.push_back(order_.key(i, facts));
  return keyed;
}

/// The edge keeps its insertion number: ties go on as if its keys had always been these.
void FrontQueue::renew(const Front& front, PlaceId id) {
  if (!isRenewed_ || !front.hasEdge(id) || id.value >= waiting_.size()) return;
  Waiting& waiting = waiting_[id.value];
  if (waiting.count == 0 || waiting.age != front[id].age) return;
  KeyedEntry entry = keyedEntry(front, id, waiting.turn);
  if (entry.moreKeys.empty() && entry.key == waiting.key) return;
  entry.version = waiting.oldest = ++version_;
  waiting.count = 1;
  waiting.key = entry.key;
  heap_.push(std::move(entry));
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
    const auto [place, age] = heap_.top().entry;
    const std::uint64_t version = heap_.top().version;
    heap_.pop();
    Waiting& waiting = waiting_[place.value];
    if (!isCurrent(front, {place, age}) || waiting.age != age || version < waiting.oldest) continue;
    --waiting.count;
    return place;
  }
  return {};
}

}  // namespace af2
