// The queue of front edges, in the order that the rule set states.
#pragma once

#include <cstdint>
#include <memory>
#include <queue>
#include <vector>

#include "engine/front/front.h"
#include "engine/rule/front_order.h"

namespace af2 {

/// Removal is lazy: an entry whose edge has left the front is skipped when it is taken out.
class FrontQueue {
 public:
  explicit FrontQueue(const AF2FrontOrder& order);

  /// Inserts the edge that leaves `id`, with its current level.
  void push(const Front& front, PlaceId id);
  /// Removes and returns the next edge; none if the queue is empty.
  PlaceId pop(const Front& front);

 private:
  struct Entry {
    PlaceId place;
    std::uint32_t age;
  };
  /// First in, first out.
  struct Bucket {
    std::vector<Entry> entries;
    std::size_t head = 0;
  };
  struct KeyedEntry {
    std::vector<double> keys;
    std::uint64_t turn;  // insertion number, breaks ties
    Entry entry;
    bool operator<(const KeyedEntry& other) const {  // std::priority_queue takes the largest first
      return keys != other.keys ? keys > other.keys : turn > other.turn;
    }
  };

  static bool isCurrent(const Front& front, const Entry& entry) {
    return front.isUsed(entry.place) && front[entry.place].age == entry.age;
  }

  const AF2FrontOrder& order_;
  const LayeredFrontOrder* layered_;   // the fast form: one bucket for each key
  std::unique_ptr<AF2EdgeQueue> own_;  // for an order that keys cannot express
  std::vector<Bucket> buckets_;
  std::size_t lowest_ = 0;
  std::priority_queue<KeyedEntry> heap_;
  std::uint64_t turn_ = 0;
};

}  // namespace af2
