// Which front edge is next: a queue in the order that the rule set states.
#pragma once

#include <cstdint>
#include <memory>
#include <queue>
#include <vector>

#include "engine/front/front.h"
#include "engine/rule/front_order.h"

namespace af2 {

/// Entries are forgotten lazily: one whose edge has left the front is skipped when its turn comes.
class FrontQueue {
 public:
  explicit FrontQueue(const AF2FrontOrder& order);

  /// Enters the edge that leaves `id`, with its present level.
  void push(const Front& front, PlaceId id);
  /// Takes out the next edge; none if there is none left.
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
    std::uint64_t turn;  // of entering
    Entry entry;
    bool operator<(const KeyedEntry& other) const {  // std::priority_queue wants the largest on top
      return keys != other.keys ? keys > other.keys : turn > other.turn;
    }
  };

  static bool isCurrent(const Front& front, const Entry& entry) {
    return front.isUsed(entry.place) && front[entry.place].age == entry.age;
  }

  const AF2FrontOrder& order_;
  const LayeredFrontOrder* layered_;   // the fast form: buckets by whole key
  std::unique_ptr<AF2EdgeQueue> own_;  // of an order that is more than keys
  std::vector<Bucket> buckets_;
  std::size_t lowest_ = 0;
  std::priority_queue<KeyedEntry> heap_;
  std::uint64_t turn_ = 0;
};

}  // namespace af2
