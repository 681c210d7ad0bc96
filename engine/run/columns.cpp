#include "engine/run/columns.h"

#include <algorithm>
#include <vector>

#include "engine/base/turn.h"

namespace af2 {
namespace {

/// Shorter loops are about to close.
constexpr int kShortestWithColumns = 8;
/// How many edges must be missing or too many; a column adds or removes two.
constexpr double kMissing = 1.3, kTooMany = 0.6, kOfColumn = 2;
/// A wedge opens where the front does not turn inward, a column ends where it does not turn
/// outward.
const double kLeastToAdd = sweepOfAngle(165 * kFullTurn / 360);
const double kMostToEnd = sweepOfAngle(200 * kFullTurn / 360);

class ColumnPlan {
 public:
  ColumnPlan(Front& front, FrontQueue& queue, const ColumnLimits& limits,
             const std::vector<std::uint8_t>& valence)
      : front_(front), queue_(queue), limits_(limits), valence_(valence) {}

  /// The first place must not get a column right after the last one.
  std::size_t alongLoop(PlaceId first) {
    if (front_.loopSize(first) < kShortestWithColumns) return 0;
    std::size_t planned = 0;
    double missing = 0;
    bool isBesideOne = true;
    PlaceId id = first;
    do {
      const double length = 0.5 * (front_.edgeLength(id) + front_.edgeLength(front_.previous(id)));
      const double inSizes = length / front_[id].size;
      missing = std::clamp(missing + inSizes - 1, -2 * kOfColumn, 2 * kOfColumn);
      const int count = isBesideOne ? 0 : wantedCount(id, inSizes, missing);
      isBesideOne = count != 0;
      if (count != 0) {
        missing -= count == 3 ? kOfColumn : -kOfColumn;
        give(id, count);
        ++planned;
      }
      id = front_.next(id);
    } while (id != first);
    return planned;
  }

 private:
  /// 3 or 1; 0: what its angle says.
  int wantedCount(PlaceId id, double inSizes, double missing) const {
    const Place& place = front_[id];
    const bool mayChange = place.vertex.value >= front_.fixedCount() && place.ownCount == 0 &&
                           place.layer >= limits_.firstLayer && valence_[place.vertex.value] <= 2 &&
                           front_[place.next].layer == place.layer &&
                           front_[place.previous].layer == place.layer;
    if (!mayChange) return 0;
    const double sweep = front_.sweep(id);
    if (inSizes > limits_.longest && missing >= kMissing && sweep >= kLeastToAdd) return 3;
    if (inSizes < limits_.shortest && missing <= -kTooMany && sweep <= kMostToEnd) return 1;
    return 0;
  }

  void give(PlaceId id, int count) {
    front_[id].ownCount = static_cast<std::int8_t>(count);
    queue_.renew(front_, id);
    queue_.renew(front_, front_.previous(id));
  }

  Front& front_;
  FrontQueue& queue_;
  const ColumnLimits& limits_;
  const std::vector<std::uint8_t>& valence_;
};

}  // namespace

std::size_t planColumns(Front& front, FrontQueue& queue, const ColumnLimits& limits,
                        const std::vector<std::uint8_t>& valence) {
  ColumnPlan plan(front, queue, limits, valence);
  std::vector<bool> isDone(front.capacity(), false);
  std::size_t planned = 0;
  for (std::size_t i = 0; i < front.capacity(); ++i) {
    if (!front.hasEdge(PlaceId(i)) || isDone[i]) continue;
    planned += plan.alongLoop(PlaceId(i));
    PlaceId id(i);
    do {
      isDone[id.value] = true;
      id = front.next(id);
    } while (id != PlaceId(i));
  }
  return planned;
}

}  // namespace af2
