// Finds the front edges near a box: a hierarchy of hashed grids, one for each band of edge lengths.
// Tuning for search speed is done only here.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/base/point.h"
#include "engine/front/front.h"

namespace af2 {

struct Box3 {
  Point3 low, high;
};

/// Each edge is stored at its midpoint, in the grid for its length. A band covers a factor of 4, so
/// a mesh of nearly uniform size uses one grid.
class FrontIndex {
 public:
  /// box        roughly holds all future vertices; it only sets the resolution of coordinates
  /// typicalLength  the length in the middle of a band
  FrontIndex(const Box3& box, double typicalLength);

  /// Inserts the edge that leaves a place, or an isolated vertex.
  void insert(const Front& front, PlaceId id);
  /// Does nothing if the edge is not in the index.
  void erase(PlaceId id);

  struct Collected {
    std::size_t count;  ///< edges that may meet the box
    /// Edges in the cells around it, and cells if all are looked at: determines the running time.
    std::size_t lookedAt;
  };
  /// Puts every edge that may meet the box into `found`, each once. The order depends only on the
  /// history of inserts and erases. `found` never shrinks.
  Collected collectNear(const Box3& box, std::vector<PlaceId>& found) const;

 private:
  static constexpr std::uint32_t kEmpty = 0xffffffffu;

  static constexpr Box3 kNowhere{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};

  struct Cell {
    std::uint64_t key = 0;
    std::uint32_t first = 0;  ///< its edges in `stored_`, side by side
    std::uint32_t edges = 0;
    std::uint32_t room = 0;  ///< for so many; 0 or a power of two
  };
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t cell = kEmpty;
  };
  /// Four numbers in one SIMD register.
  using Four = float __attribute__((vector_size(16)));
  using FourBits = std::int32_t __attribute__((vector_size(16)));
  using TwoPairs = std::int64_t __attribute__((vector_size(16)));
  /// The approximate edges of cells, each cell's side by side, and their places. A search reads
  /// nothing else of an edge.
  struct Stored {
    /// The edge's midpoint x, y, z, relative to the origin of the index. The fourth number is the
    /// largest distance along an axis from the midpoint to a point of the edge.
    std::vector<Four> edges;
    std::vector<PlaceId> places;
  };
  /// Where the edge of a place is stored.
  struct Entry {
    std::uint32_t cell = kEmpty;
    std::uint32_t at = 0;  ///< in the cell
  };
  /// A box in the single precision of the entries, slightly enlarged.
  struct Query {
    Four center, half;  ///< along x, y, z; the fourth half is infinite
    bool mayMeet(Four edge) const {
      const Four away = edge - center, reach = half + edge[3];
      constexpr std::int32_t kNoSign = 0x7fffffff;
      const auto isNear =
          std::bit_cast<Four>(std::bit_cast<FourBits>(away) &
                              FourBits{kNoSign, kNoSign, kNoSign, kNoSign}) <= reach;
      const auto pairs = std::bit_cast<TwoPairs>(isNear);
      return (pairs[0] & pairs[1]) == -1;
    }
  };
  struct Search {
    Query query;
    std::vector<PlaceId>& found;
    Collected collected;
  };
  struct Band {
    double cellSize = 1, inverseCellSize = 1;
    /// Offset by half a cell, so that a front in the plane z = 0 stays in one layer.
    Point3 origin;
    /// Largest distance so far from a midpoint to a point of its edge along an axis.
    double reach = 0;
    Box3 midpoints = kNowhere;  ///< bounding box of all midpoints
    std::size_t edges = 0;
    std::vector<Cell> cells;  ///< in order of first use
    std::vector<Slot> slots;  ///< open addressing into cells; a power of two
    /// Whether a block of 4 x 4 x 4 cells may be in use, by hash; as many entries as slots.
    std::vector<std::uint8_t> isBlockUsed;
  };
  struct CellRange {
    std::int64_t low[3], high[3];
    /// Number of cells; for very large ranges any large number.
    std::uint64_t count() const {
      constexpr std::uint64_t kMany = 1u << 20;
      std::uint64_t product = 1;
      for (int i = 0; i < 3; ++i)
        product *= std::min(static_cast<std::uint64_t>(high[i] - low[i]) + 1, kMany);
      return product;
    }
    /// Whether the cell of a key may be in the range: keys repeat after very many cells.
    bool contains(std::uint64_t key) const {
      constexpr std::uint64_t kMask = (1u << kKeyBits) - 1;
      for (int i = 0; i < 3; ++i) {
        const std::uint64_t fromLow = (key >> i * kKeyBits) - static_cast<std::uint64_t>(low[i]);
        if ((fromLow & kMask) > static_cast<std::uint64_t>(high[i] - low[i])) return false;
      }
      return true;
    }
  };

  static std::uint64_t keyOf(std::int64_t x, std::int64_t y, std::int64_t z) {
    constexpr std::uint64_t kMask = (1u << kKeyBits) - 1;
    return (static_cast<std::uint64_t>(x) & kMask) |
           (static_cast<std::uint64_t>(y) & kMask) << kKeyBits |
           (static_cast<std::uint64_t>(z) & kMask) << 2 * kKeyBits;
  }
  /// The block that holds a cell.
  static std::uint64_t blockOf(std::uint64_t key) {
    constexpr std::uint64_t kLow = 3;
    return key & ~(kLow | kLow << kKeyBits | kLow << 2 * kKeyBits);
  }
  /// Adjacent cells go to different slots, also those above each other: the bits of z, which begin
  /// at bit 42, would not reach the low bits otherwise.
  static std::size_t hash(std::uint64_t key) {
    key = (key ^ key >> 37) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(key ^ (key >> 32));
  }

  std::size_t bandOf(double squaredLength) const;
  static bool mayHold(const Band& band, const Box3& box);
  CellRange cellsAround(const Band& band, const Box3& box) const;
  std::uint64_t keyAt(const Band& band, const Point3& point) const;

  /// The slot of a key, or the empty slot where it would go.
  static std::size_t slotOf(const Band& band, std::uint64_t key) {
    const std::size_t mask = band.slots.size() - 1;
    std::size_t i = hash(key) & mask;
    while (band.slots[i].cell != kEmpty && band.slots[i].key != key) i = (i + 1) & mask;
    return i;
  }
  std::uint32_t findOrAdd(Band& band, std::uint64_t key);
  void makeRoom(Cell& cell);
  void giveBack(const Cell& cell);
  static void rehash(Band& band, std::size_t slots);
  static void markBlock(Band& band, std::uint64_t key);
  void dropEmptyCells(Band& band);
  Query queryOf(const Box3& box) const;
  float roundedUp(double half, double farthest) const;
  void collectInRange(const Band& band, const CellRange& range, Search& search) const;
  void collectInCell(const Cell& cell, Search& search) const;

  static constexpr int kKeyBits = 21;
  static constexpr int kBands = 32;
  static constexpr std::uint32_t kBandShift = 27;  // an entry's cell: the band is in the high bits

  double perSquaredLength_;  // times the squared length: position among the bands
  Point3 origin_;
  std::vector<Band> bands_;
  std::size_t firstBand_ = kBands, lastBand_ = 0;  // bands that hold or have held an edge
  std::vector<Entry> entries_;                     // by place
  Stored stored_;
  /// By the logarithm of their room: where in `stored_` parts begin that no cell has.
  std::array<std::vector<std::uint32_t>, 32> free_;
};

}  // namespace af2
