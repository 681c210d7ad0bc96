#include "geometry/edges/even_loops.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>

#include "engine/base/elementary.h"
#include "geometry/base/disjoint_sets.h"
#include "geometry/edges/odd_nodes.h"

namespace af2::geometry {

namespace {

using Indices = std::vector<std::size_t>;  // ascending, each once

/// Those that are in one of them, but not in both.
Indices symmetricDifference(const Indices& a, const Indices& b) {
  Indices difference;
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(difference));
  return difference;
}

struct Change {
  int by = 0;
  double cost = 0;
};

/// Of one segment more or one fewer; none if it is not possible.
std::optional<double> costOf(const SegmentCount& count, int change) {
  if (count.isFixed) return std::nullopt;
  if (change < 0 && count.segments <= std::max<std::size_t>(1, count.least)) return std::nullopt;
  constexpr double kShortest = 1e-6;  // keeps costs finite
  const auto now = static_cast<double>(count.segments);
  const double distortion = logarithm((now + change) / std::max(count.wanted, kShortest));
  return now * distortion * distortion;
}

/// The cheaper one of a segment more and a segment less on all of these edges; none if neither is
/// possible.
std::optional<Change> changeOf(const Indices& edges, const std::vector<SegmentCount>& counts) {
  std::optional<Change> cheaper;
  for (const int by : {1, -1}) {
    std::optional<double> cost = 0;
    for (const std::size_t i : edges) {
      const std::optional<double> ofOne = costOf(counts[i], by);
      cost = cost && ofOne ? std::optional(*cost + *ofOne) : std::nullopt;
    }
    if (cost && (!cheaper || *cost < cheaper->cost)) cheaper = {by, *cost};
  }
  return cheaper;
}

/// Sets of parts, by which the parity of some parts is to be changed: Gaussian elimination over the
/// field of two elements.
class PartSets {
 public:
  /// Sets that come first are preferred.
  void add(Indices parts, std::size_t set) {
    Indices sets{set};
    while (!parts.empty()) {
      const auto found = byFirst_.find(parts.front());
      if (found == byFirst_.end()) {
        const std::size_t first = parts.front();
        byFirst_[first] = {std::move(parts), std::move(sets)};
        return;
      }
      parts = symmetricDifference(parts, found->second.parts);
      sets = symmetricDifference(sets, found->second.sets);
    }
  }

  /// Sets that together contain the wanted parts an odd number of times, and all others an even
  /// number of times. Where this is not possible, it may fail for some parts, but for fewer than
  /// without any set.
  Indices setsFor(const Indices& wanted) const {
    Indices parts = wanted, sets;
    std::size_t left = 0;
    while (!parts.empty()) {
      const auto found = byFirst_.find(parts.front());
      if (found == byFirst_.end()) {
        parts.erase(parts.begin());
        ++left;
        continue;
      }
      parts = symmetricDifference(parts, found->second.parts);
      sets = symmetricDifference(sets, found->second.sets);
    }
    return left < wanted.size() ? sets : Indices();
  }

 private:
  struct Combination {
    Indices parts, sets;
  };
  std::map<std::size_t, Combination> byFirst_;  // by the first of its parts
};

/// The nodes of its graph are the loops, and one that stands for the outside. An edge links the two
/// loops that use it, or the only one with the outside.
class Evening {
 public:
  Evening(const std::vector<SegmentCount>& counts, const std::vector<CountedLoop>& loops,
          const std::vector<FacingCounts>& facing)
      : outside_(loops.size()),
        facing_(facing),
        loopsOf_(counts.size()),
        isOdd_(loops.size() + 1, false) {
    for (std::size_t loop = 0; loop < loops.size(); ++loop) add(counts, loop, loops[loop]);
    for (std::size_t i = 0; i < counts.size(); ++i) changes_.push_back(changeOf({i}, counts));
    result_.changes.assign(counts.size(), 0);
    linkFacing(counts);
    linkSingle();
  }

  EvenLoops result() {
    findParts();
    useSharedEdges();
    linkOddParts();
    const std::vector<bool> isChosen = joinOddNodes(isOdd_, outside_, links_);
    for (std::size_t i = 0; i < links_.size(); ++i) {
      if (!isChosen[i]) continue;
      if (i < together_.size())
        take(together_[i]);
      else if (i < together_.size() + countOf_.size())
        take(countOf_[i - together_.size()]);
      else
        result_.odd.push_back(links_[i].from);
    }
    return std::move(result_);
  }

 private:
  void add(const std::vector<SegmentCount>& counts, std::size_t loop, const CountedLoop& counted) {
    isOdd_[loop] = counted.hasOddRest;
    for (const std::size_t count : counted.counts) {
      if (counts[count].segments % 2 == 1) isOdd_[loop] = !isOdd_[loop];
      Indices& users = loopsOf_[count];
      if (!users.empty() && users.back() == loop)
        users.pop_back();  // twice is as good as not at all
      else
        users.push_back(loop);
    }
  }

  void linkFacing(const std::vector<SegmentCount>& counts) {
    for (const FacingCounts& facing : facing_) {
      Indices users;
      for (const std::size_t count : facing) {
        users = symmetricDifference(users, loopsOf_[count]);
        if (changes_[count]) changes_[count]->cost += kAlone;
      }
      const std::optional<Change> change = changeOf(facing, counts);
      if (!change || users.empty() || users.size() > 2) continue;
      addLink(users, change->cost);
      together_.push_back({&facing, change->by});
    }
  }

  void linkSingle() {
    for (std::size_t count = 0; count < loopsOf_.size(); ++count) {
      const Indices& users = loopsOf_[count];
      if (!changes_[count] || users.empty()) continue;
      if (users.size() > 2) {
        shared_.push_back(count);
        continue;
      }
      addLink(users, changes_[count]->cost);
      countOf_.push_back(count);
    }
    std::ranges::stable_sort(shared_, {}, [&](std::size_t count) { return changes_[count]->cost; });
  }

  void addLink(const Indices& users, double cost) {
    links_.push_back({users[0], users.size() == 2 ? users[1] : outside_, cost});
  }

  void findParts() {
    DisjointSets parts(isOdd_.size());
    for (const NodeLink& link : links_)
      parts.join(static_cast<std::uint32_t>(link.from), static_cast<std::uint32_t>(link.to));
    for (std::size_t node = 0; node < isOdd_.size(); ++node)
      partOf_.push_back(parts.of(static_cast<std::uint32_t>(node)));
  }

  /// Parts that have an odd number of these loops, and no link with the outside.
  Indices partsWithOddNumberOf(const Indices& loops) const {
    std::map<std::size_t, bool> isOddPart;
    for (const std::size_t loop : loops)
      if (partOf_[loop] != partOf_[outside_]) isOddPart[partOf_[loop]] ^= true;
    Indices parts;
    for (const auto& [part, isOdd] : isOddPart)
      if (isOdd) parts.push_back(part);
    return parts;
  }

  /// Parts in which the number of odd loops is odd, so that links alone cannot make all even.
  Indices oddParts() const {
    Indices loops;
    for (std::size_t loop = 0; loop < outside_; ++loop)
      if (isOdd_[loop]) loops.push_back(loop);
    return partsWithOddNumberOf(loops);
  }

  /// Changes edges that three and more loops use, where parts need them.
  void useSharedEdges() {
    const Indices wanted = oddParts();
    if (wanted.empty()) return;
    PartSets sets;
    for (const std::size_t count : shared_) sets.add(partsWithOddNumberOf(loopsOf_[count]), count);
    for (const std::size_t count : sets.setsFor(wanted)) {
      take(count);
      for (const std::size_t loop : loopsOf_[count]) isOdd_[loop] = !isOdd_[loop];
    }
  }

  /// In parts that are odd still, one loop must stay odd. Links that cost more than all others
  /// stand for this.
  void linkOddParts() {
    double all = 1;
    for (const NodeLink& link : links_) all += link.weight;
    const Indices odd = oddParts();
    for (std::size_t loop = 0; loop < outside_; ++loop)
      if (std::ranges::binary_search(odd, partOf_[loop])) links_.push_back({loop, outside_, all});
  }

  struct Together {
    const FacingCounts* facing;
    int change;
  };

  /// A count may be taken by itself and together with others: then it does not change.
  void take(std::size_t count, int by) {
    int& change = result_.changes[count];
    change = change == 0 ? by : 0;
  }
  void take(std::size_t count) { take(count, changes_[count]->by); }
  void take(const Together& together) {
    for (const std::size_t count : *together.facing) take(count, together.change);
  }

  /// The cost of changing only one side of a strip, which leaves irregular vertices in the strip:
  /// about that of dividing a single segment.
  static constexpr double kAlone = 0.5;

  const std::size_t outside_;
  const std::vector<FacingCounts>& facing_;
  std::vector<Indices> loopsOf_;                // by count: that use it an odd number of times
  std::vector<std::optional<Change>> changes_;  // by count
  std::vector<bool> isOdd_;                     // by node
  std::vector<NodeLink> links_;
  std::vector<Together> together_;  // by link, of the first ones
  Indices countOf_;                 // by link, of those after them
  Indices shared_;                  // counts that three and more loops use, the cheapest first
  Indices partOf_;                  // by node: connected by links
  EvenLoops result_;
};

}  // namespace

EvenLoops makeLoopsEven(const std::vector<SegmentCount>& counts,
                        const std::vector<CountedLoop>& loops,
                        const std::vector<FacingCounts>& facing) {
  return Evening(counts, loops, facing).result();
}

}  // namespace af2::geometry
