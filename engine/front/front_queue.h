// The queue of front edges, in the order that the rule set states.
#pragma once

#include <cstdint>
#include <memory>
#include <queue>
#include <vector>

#include "engine/front/front.h"
#include "engine/rule/front_order.h"

namespace af2 {

/// Removal is lazy: an entry whose edge has left the front, or has another entry, is skipped when
/// it is taken out.
class FrontQueue {
 public:
  explicit FrontQueue(const AF2FrontOrder& order);

  /// Inserts the edge that leaves `id`, with its current level.
  void push(const Front& front, PlaceId id);
  /// Whether `renew` does anything.
  bool isRenewed() const { return isRenewed_; }
  /// An end of a waiting edge has another neighbour: computes the keys again if they use turns.
  void renew(const Front& front, PlaceId id);
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
    double key = 0;                // the first key
    std::vector<double> moreKeys;  // usually none
    std::uint64_t turn;            // insertion number, breaks ties
    std::uint64_t version;         // distinguishes entries of one edge
    Entry entry;
    bool operator<(const KeyedEntry& other) const;
  };
  /// The entries of the edge that leaves a place.
  struct Waiting {
    std::uint32_t age = 0;     ///< of the edge
    std::uint32_t count = 0;   ///< valid entries; 0: it does not wait
    std::uint64_t turn = 0;    ///< of the last entry
    std::uint64_t oldest = 0;  ///< entries with lower versions are not valid
    double key = 0;            ///< of the last entry
  };

  static bool isCurrent(const Front& front, const Entry& entry) {
    return front.isUsed(entry.place) && front[entry.place].age == entry.age;
  }
  KeyedEntry keyedEntry(const Front& front, PlaceId id, std::uint64_t turn) const;

  const AF2FrontOrder& order_;
  const LayeredFrontOrder* layered_;   // the fast form: one bucket for each key
  std::unique_ptr<AF2EdgeQueue> own_;  // for an order that keys cannot express
  bool isRenewed_;
  std::vector<Bucket> buckets_;
  std::size_t lowest_ = 0;
  std::priority_queue<KeyedEntry> heap_;
  std::vector<Waiting> waiting_;  // by place, for the heap
  std::uint64_t turn_ = 0, version_ = 0;
};

}  // namespace af2
