#include "engine/front/front_loops.h"

#include <utility>

#include "engine/front/front.h"

namespace af2 {
namespace {

template <class Visit>
void forEachOfLoop(const Front& front, PlaceId first, Visit&& visit) {
  PlaceId id = first;
  do {
    visit(id);
    id = front.next(id);
  } while (id != first);
}

}  // namespace

void FrontLoops::number(const Front& front) {
  constexpr std::uint32_t kNone = 0xffffffffu;
  places_.assign(front.capacity(), {kNone, false});
  sizes_.clear();
  for (std::size_t i = 0; i < front.capacity(); ++i) {
    if (!front.hasEdge(PlaceId(i)) || places_[i].loop != kNone) continue;
    const auto loop = static_cast<std::uint32_t>(sizes_.size());
    sizes_.push_back(0);
    bool isWhole = true;
    forEachOfLoop(front, PlaceId(i), [&](PlaceId id) {
      at(id) = {loop, sizes_[loop] % 2 != 0};
      ++sizes_[loop];
      isWhole = isWhole && front.hasEdge(id);
    });
    // Of a loop that is shown in part, the rest is taken to make it even.
    if (!isWhole) sizes_[loop] += sizes_[loop] % 2;
  }
}

void FrontLoops::joinChains(const Front& front, std::span<const std::pair<PlaceId, bool>> colours) {
  for (const auto& [place, wanted] : colours) {
    const std::uint32_t whole = at(colours.front().first).loop, part = at(place).loop;
    const bool flips = colour(place) != wanted;
    forEachOfLoop(front, place, [&](PlaceId id) {
      at(id).loop = whole;
      at(id).colour ^= flips;
    });
    if (part == whole) continue;
    sizes_[whole] += sizes_[part];
    sizes_[part] = 0;
  }
}

void FrontLoops::add(PlaceId before, PlaceId added) {
  if (places_.size() <= added.value) places_.resize(added.value + 1);
  at(added) = {at(before).loop, !at(before).colour};
  ++sizes_[at(added).loop];
}

void FrontLoops::exchanged(const Front& front, PlaceId p, PlaceId q) {
  if (at(p).loop == at(q).loop)
    divide(front, p, q);
  else
    join(front, p, q);
}

/// Walks along both parts at once, so that the shorter one decides how long it takes.
void FrontLoops::divide(const Front& front, PlaceId p, PlaceId q) {
  PlaceId alongP = front.next(p), alongQ = front.next(q);
  std::uint32_t size = 1;
  for (; alongP != p && alongQ != q; ++size) {
    alongP = front.next(alongP);
    alongQ = front.next(alongQ);
  }
  const auto [shorter, longer] = alongP == p ? std::pair(p, q) : std::pair(q, p);
  const bool wasOdd = isInOddLoop(p);
  sizes_[at(longer).loop] -= size;
  const auto loop = static_cast<std::uint32_t>(sizes_.size());
  sizes_.push_back(size);
  forEachOfLoop(front, shorter, [&](PlaceId id) { at(id).loop = loop; });
  if (!wasOdd) return;
  for (const PlaceId part : {shorter, longer})
    if (!isInOddLoop(part)) colourAgain(front, part);
}

void FrontLoops::join(const Front& front, PlaceId p, PlaceId q) {
  const bool areBothOdd = isInOddLoop(p) && isInOddLoop(q);
  const bool isPShorter = sizeOfLoop(p) < sizeOfLoop(q);
  const std::uint32_t shorter = at(isPShorter ? p : q).loop, longer = at(isPShorter ? q : p).loop;
  const bool flips = colour(p) != colour(q);
  // The places of the shorter loop now follow one another between p and q.
  for (PlaceId id = isPShorter ? p : q; at(id).loop == shorter; id = front.next(id)) {
    at(id).loop = longer;
    at(id).colour ^= flips;
  }
  sizes_[longer] += std::exchange(sizes_[shorter], 0);
  if (areBothOdd) colourAgain(front, p);
}

void FrontLoops::colourAgain(const Front& front, PlaceId place) {
  bool next = colour(place);
  forEachOfLoop(front, place, [&](PlaceId id) { at(id).colour = std::exchange(next, !next); });
}

bool FrontLoops::areSound(const Front& front) const {
  std::vector<bool> isSeen(front.capacity(), false);
  for (std::size_t i = 0; i < front.capacity(); ++i) {
    const PlaceId first(i);
    if (!front.hasEdge(first) || isSeen[i]) continue;
    int size = 0;
    bool alternates = true, isOne = true;
    forEachOfLoop(front, first, [&](PlaceId id) {
      isSeen[id.value] = true;
      ++size;
      alternates = alternates && colour(id) != colour(front.next(id));
      isOne = isOne && areInOneLoop(id, first);
    });
    if (!isOne || size != sizeOfLoop(first) || (size % 2 == 0 && !alternates)) return false;
  }
  return true;
}

bool FrontLoops::allow(const Front& front, PlaceId base, std::span<const PlaceId> joined) const {
  // An odd loop stays odd, or leaves one odd part, whatever divides it.
  if (isInOddLoop(base)) return true;
  if (joined.size() % 2 != 0) return false;
  const auto isOfLoop = [&](PlaceId id) { return !id.isNone() && front.hasEdge(id); };
  const auto isUnlike = [&](std::size_t i) {
    return colour(joined[i]) != (colour(base) != (i % 2 == 0));
  };
  for (std::size_t i = 0; i < joined.size(); ++i) {
    if (!isOfLoop(joined[i]) || isInOddLoop(joined[i])) continue;
    const bool isOwn = areInOneLoop(joined[i], base);
    if (isOwn && isUnlike(i)) return false;
    // Another loop is joined where the walk meets it first, and divided where it meets it again.
    for (std::size_t j = 0; !isOwn && j < i; ++j)
      if (isOfLoop(joined[j]) && areInOneLoop(joined[j], joined[i]) && isUnlike(j) != isUnlike(i))
        return false;
  }
  return true;
}

}  // namespace af2
