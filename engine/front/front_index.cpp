#include "engine/front/front_index.h"

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"

namespace af2 {
namespace {

/// Cell size as a multiple of the band's longest edge: large enough that a step visits few cells,
/// small enough that a search finds few edges that are not neighbours.
constexpr double kCellPerLength = 4.0;
constexpr int kMiddleBand = 16;

/// The largest integer not above x. Faster than std::floor, which is a function call if the
/// compiler may use SSE2 only.
std::int64_t wholePart(double x) {
  const auto truncated = static_cast<std::int64_t>(x);
  return truncated - (static_cast<double>(truncated) > x);
}

void include(Box3& box, const Point3& p) {
  box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
  box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
}

}  // namespace

FrontIndex::FrontIndex(const Box3& box, double typicalLength)
    : perSquaredLength_(4 / (typicalLength * typicalLength)), origin_(box.low), bands_(kBands) {
  for (int i = 0; i < kBands; ++i) {
    Band& band = bands_[static_cast<std::size_t>(i)];
    const double longest = typicalLength * std::ldexp(2.0, 2 * (i - kMiddleBand));
    band.cellSize = kCellPerLength * longest;
    band.inverseCellSize = 1 / band.cellSize;
    const double half = 0.5 * band.cellSize;
    band.origin = box.low - Point3{half, half, half};
  }
}

std::size_t FrontIndex::bandOf(double squaredLength) const {
  // Band i holds lengths in typical * [1/2, 2) * 4^(i - middle).
  const double ratio = perSquaredLength_ * squaredLength;
  if ((ratio >= 1 && ratio < 16) || squaredLength == 0) return kMiddleBand;
  const int exponent = std::clamp(std::ilogb(ratio), -4 * kBands, 4 * kBands);
  const int band = kMiddleBand + (exponent >= 0 ? exponent / 4 : -((3 - exponent) / 4));
  return static_cast<std::size_t>(std::clamp(band, 0, kBands - 1));
}

std::uint64_t FrontIndex::keyAt(const Band& band, const Point3& point) const {
  const Point3 d = band.inverseCellSize * (point - band.origin);
  return keyOf(wholePart(d.x), wholePart(d.y), wholePart(d.z));
}

FrontIndex::CellRange FrontIndex::cellsAround(const Band& band, const Box3& box) const {
  const auto cellIndex = [&](double d) {
    constexpr double kFar = 1e15;  // cells; integers of this size are exact
    return wholePart(std::clamp(d * band.inverseCellSize, -kFar, kFar));
  };
  const Point3 reach{band.reach, band.reach, band.reach};
  const Point3 low = box.low - reach - band.origin, high = box.high + reach - band.origin;
  return {{cellIndex(low.x), cellIndex(low.y), cellIndex(low.z)},
          {cellIndex(high.x), cellIndex(high.y), cellIndex(high.z)}};
}

/// Single precision is enough to leave out distant edges; the rounding error is added to the box.
float FrontIndex::roundedUp(double half, double farthest) const {
  constexpr double kRounding = 2.4e-7;  // 4 * 2^-24
  return static_cast<float>((1 + kRounding) * half + kRounding * farthest);
}

FrontIndex::Query FrontIndex::queryOf(const Box3& box) const {
  const Point3 center = 0.5 * (box.low + box.high) - origin_, half = 0.5 * (box.high - box.low);
  const auto single = [](double c) { return static_cast<float>(c); };
  const auto grown = [&](double h, double c) { return roundedUp(h, std::abs(c)); };
  Query query;
  query.center = Four{single(center.x), single(center.y), single(center.z), 0};
  query.half =
      Four{grown(half.x, center.x), grown(half.y, center.y), grown(half.z, center.z), INFINITY};
  return query;
}

/// Most bands can be skipped: where sizes are graded, their edges are elsewhere.
bool FrontIndex::mayHold(const Band& band, const Box3& box) {
  const Point3 &low = band.midpoints.low, &high = band.midpoints.high;
  const double reach = band.reach;
  return band.edges > 0 && box.low.x <= high.x + reach && box.high.x >= low.x - reach &&
         box.low.y <= high.y + reach && box.high.y >= low.y - reach &&
         box.low.z <= high.z + reach && box.high.z >= low.z - reach;
}

FrontIndex::Collected FrontIndex::collectNear(const Box3& box, std::vector<PlaceId>& found) const {
  Search search{queryOf(box), found, {0, 0}};
  for (std::size_t b = firstBand_; b <= lastBand_; ++b) {
    const Band& band = bands_[b];
    if (!mayHold(band, box)) continue;
    const CellRange range = cellsAround(band, box);
    if (range.count() <= band.cells.size()) {
      collectInRange(band, range, search);
    } else {
      search.collected.lookedAt += band.cells.size();
      for (const Cell& cell : band.cells)
        if (range.contains(cell.key)) collectInCell(cell, search);
    }
  }
  return search.collected;
}

void FrontIndex::collectInRange(const Band& band, const CellRange& range, Search& search) const {
  const std::size_t mask = band.slots.size() - 1;
  constexpr std::int64_t kBlock = 4;
  constexpr std::uint64_t kFew = 8;
  const bool areMany = range.count() > kFew;
  for (std::int64_t z = range.low[2]; z <= range.high[2]; ++z) {
    for (std::int64_t y = range.low[1]; y <= range.high[1]; ++y) {
      for (std::int64_t x = range.low[0]; x <= range.high[0]; ++x) {
        const std::uint64_t key = keyOf(x, y, z);
        if (areMany && !band.isBlockUsed[hash(blockOf(key)) & mask]) {
          x |= kBlock - 1;  // skip to the next block
          continue;
        }
        const std::uint32_t cell = band.slots[slotOf(band, key)].cell;
        if (cell != kEmpty) collectInCell(band.cells[cell], search);
      }
    }
  }
}

/// Stores every edge before the test that keeps or drops it: a branch would be mispredicted often.
void FrontIndex::collectInCell(const Cell& cell, Search& search) const {
  std::size_t& count = search.collected.count;
  search.collected.lookedAt += cell.edges;
  if (search.found.size() < count + cell.edges) search.found.resize(2 * (count + cell.edges));
  const Query query = search.query;
  PlaceId* found = search.found.data() + count;
  const Four* edges = stored_.edges.data() + cell.first;
  const PlaceId* places = stored_.places.data() + cell.first;
  // The newest first: of several that hit a zone, the first one is named as the reason.
  for (std::uint32_t i = cell.edges; i-- > 0;) {
    *found = places[i];
    found += query.mayMeet(edges[i]);
  }
  count = static_cast<std::size_t>(found - search.found.data());
}

void FrontIndex::insert(const Front& front, PlaceId id) {
  const Point3& from = front[id].point.position;
  const Point3& to = front.hasEdge(id) ? front[front.next(id)].point.position : from;
  const Point3 along = to - from;
  const std::size_t bandIndex = bandOf(dot(along, along));
  const double reach = 0.5 * std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
  Band& band = bands_[bandIndex];
  band.reach = std::max(band.reach, reach);
  firstBand_ = std::min(firstBand_, bandIndex);
  lastBand_ = std::max(lastBand_, bandIndex);

  const Point3 middle = 0.5 * (from + to);
  include(band.midpoints, middle);
  const std::uint32_t cellIndex = findOrAdd(band, keyAt(band, middle));
  Cell& cell = band.cells[cellIndex];
  if (id.value >= entries_.size()) entries_.resize(std::max(front.capacity(), 2 * entries_.size()));
  const Point3 d = middle - origin_;
  const double farthest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  if (cell.edges == cell.room) makeRoom(cell);
  const std::size_t at = cell.first + cell.edges;
  stored_.edges[at] = Four{static_cast<float>(d.x), static_cast<float>(d.y),
                           static_cast<float>(d.z), roundedUp(reach, farthest)};
  stored_.places[at] = id;
  entries_[id.value] = {static_cast<std::uint32_t>(bandIndex) << kBandShift | cellIndex,
                        cell.edges};
  ++cell.edges;
  ++band.edges;
  if (band.cells.size() > 64 && band.cells.size() > 4 * band.edges) dropEmptyCells(band);
}

void FrontIndex::erase(PlaceId id) {
  if (id.value >= entries_.size() || entries_[id.value].cell == kEmpty) return;
  Entry& entry = entries_[id.value];
  Band& band = bands_[entry.cell >> kBandShift];
  Cell& cell = band.cells[entry.cell & ((1u << kBandShift) - 1)];
  // The cell's last edge takes its place.
  const std::size_t at = cell.first + entry.at, last = cell.first + cell.edges - 1;
  const PlaceId moved = stored_.places[last];
  stored_.edges[at] = stored_.edges[last];
  stored_.places[at] = moved;
  entries_[moved.value].at = entry.at;
  entry.cell = kEmpty;
  --cell.edges;
  --band.edges;
}

/// Twice as much, in a part of `stored_` that no cell has any more, or at its end.
void FrontIndex::makeRoom(Cell& cell) {
  constexpr std::uint32_t kFirstRoom = 8;
  Cell larger = cell;
  larger.room = std::max(kFirstRoom, 2 * cell.room);
  std::vector<std::uint32_t>& free = free_[static_cast<std::size_t>(std::countr_zero(larger.room))];
  if (free.empty()) {
    larger.first = static_cast<std::uint32_t>(stored_.places.size());
    stored_.edges.resize(stored_.edges.size() + larger.room);
    stored_.places.resize(stored_.places.size() + larger.room);
  } else {
    larger.first = free.back();
    free.pop_back();
  }
  std::copy_n(stored_.edges.begin() + cell.first, cell.edges, stored_.edges.begin() + larger.first);
  std::copy_n(stored_.places.begin() + cell.first, cell.edges,
              stored_.places.begin() + larger.first);
  giveBack(cell);
  cell = larger;
}

void FrontIndex::giveBack(const Cell& cell) {
  if (cell.room > 0)
    free_[static_cast<std::size_t>(std::countr_zero(cell.room))].push_back(cell.first);
}

std::uint32_t FrontIndex::findOrAdd(Band& band, std::uint64_t key) {
  if (2 * (band.cells.size() + 1) > band.slots.size())
    rehash(band, std::max<std::size_t>(64, 2 * band.slots.size()));
  Slot& slot = band.slots[slotOf(band, key)];
  if (slot.cell != kEmpty) return slot.cell;
  AF2_CHECK(band.cells.size() < (1u << kBandShift), "fewer than 2^27 cells are in use");
  slot = {key, static_cast<std::uint32_t>(band.cells.size())};
  band.cells.push_back({key});
  markBlock(band, key);
  return slot.cell;
}

void FrontIndex::rehash(Band& band, std::size_t slots) {
  band.slots.assign(slots, Slot{});
  band.isBlockUsed.assign(slots, 0);
  for (std::size_t c = 0; c < band.cells.size(); ++c) {
    const std::uint64_t key = band.cells[c].key;
    band.slots[slotOf(band, key)] = {key, static_cast<std::uint32_t>(c)};
    markBlock(band, key);
  }
}

void FrontIndex::markBlock(Band& band, std::uint64_t key) {
  band.isBlockUsed[hash(blockOf(key)) & (band.isBlockUsed.size() - 1)] = 1;
}

/// Removes the empty cells that the moving front leaves behind, which would eventually fill the
/// table.
void FrontIndex::dropEmptyCells(Band& band) {
  std::size_t kept = 0;
  band.midpoints = kNowhere;
  for (const Cell& cell : band.cells) {
    if (cell.edges == 0) {
      giveBack(cell);
      continue;
    }
    for (std::uint32_t i = 0; i < cell.edges; ++i) {
      std::uint32_t& own = entries_[stored_.places[cell.first + i].value].cell;
      own = (own & ~((1u << kBandShift) - 1)) | static_cast<std::uint32_t>(kept);
      // `half` already includes the entry's rounding error.
      const Four edge = stored_.edges[cell.first + i];
      const Point3 middle = origin_ + Point3{edge[0], edge[1], edge[2]};
      const Point3 half{edge[3], edge[3], edge[3]};
      include(band.midpoints, middle - half);
      include(band.midpoints, middle + half);
    }
    band.cells[kept++] = cell;
  }
  band.cells.resize(kept);
  std::size_t slots = 64;
  while (slots < 4 * (kept + 1)) slots *= 2;
  rehash(band, slots);
}

}  // namespace af2
