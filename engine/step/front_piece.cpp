#include "engine/step/front_piece.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "engine/base/segment.h"
#include "engine/front/front.h"
#include "engine/step/neighborhood.h"

namespace af2 {
namespace {

/// Cuts a piece out of a front.
class Cutter {
 public:
  Cutter(const Front& front, const StepChart& chart, PlaceId base, double reach)
      : front_(front), chart_(chart), base_(base), reach_(reach) {
    const Point2 from = chart_.project(front_[base].point).position;
    const Point2 to = chart_.project(front_[front_.next(base)].point).position;
    middle_ = 0.5 * (from + to);
    isKept_.assign(front_.capacity(), false);
    for (std::size_t i = 0; i < front_.capacity(); ++i)
      isKept_[i] = front_.hasEdge(PlaceId(i)) && isNear(PlaceId(i));
    for (const PlaceId id : {front_.previous(base), base, front_.next(base)})
      if (front_.hasEdge(id)) isKept_[id.value] = true;
  }

  LocalFront cut() {
    // Open chains begin where the edge before is not kept; what is then left is closed.
    for (std::size_t i = 0; i < isKept_.size(); ++i)
      if (isKept_[i] && !isKept_[front_.previous(PlaceId(i)).value]) addChain(PlaceId(i));
    for (std::size_t i = 0; i < isKept_.size(); ++i)
      if (isKept_[i]) addChain(PlaceId(i));
    if (front_.loops().areNumbered() && !front_.loops().isInOddLoop(base_)) addColours();
    for (std::size_t i = 0; i < front_.capacity(); ++i) addIsolated(PlaceId(i));
    return std::move(local_);
  }

  std::size_t vertexAt(PlaceId id) {
    const Place& place = front_[id];
    const Point2 at = chart_.project(place.point).position;
    const auto [known, isNew] = numbers_.try_emplace(std::tuple(place.vertex.value, at.x, at.y),
                                                     local_.piece.vertices.size());
    if (isNew) {
      local_.piece.vertices.push_back(at);
      local_.ids.push_back(place.vertex);
    }
    return known->second;
  }

 private:
  bool isHidden(PlaceId id) const {
    return chart_.project(front_[id].point).view == ChartView::Hidden;
  }

  bool isNear(PlaceId id) const {
    const PlaceId next = front_.next(id);
    return !isHidden(id) && !isHidden(next) &&
           distanceToSegment(middle_, chart_.project(front_[id].point).position,
                             chart_.project(front_[next].point).position) <= reach_;
  }

  void addChain(PlaceId first) {
    std::vector<std::size_t>& chain = local_.piece.chains.emplace_back();
    starts_.push_back(first);
    chain.push_back(vertexAt(first));
    for (PlaceId id = first; isKept_[id.value]; id = front_.next(id)) {
      isKept_[id.value] = false;
      chain.push_back(vertexAt(front_.next(id)));
    }
  }

  /// For each open chain of the base's loop, the colour of a vertex that no other chain has.
  void addColours() {
    const FrontLoops& loops = front_.loops();
    std::vector<int> uses(local_.piece.vertices.size(), 0);
    for (const auto& chain : local_.piece.chains)
      for (const std::size_t v : chain) ++uses[v];
    for (std::size_t c = 0; c < starts_.size(); ++c) {
      const auto& chain = local_.piece.chains[c];
      if (chain.front() == chain.back() || !loops.areInOneLoop(starts_[c], base_)) continue;
      const auto own = std::ranges::find_if(chain, [&](std::size_t v) { return uses[v] == 1; });
      if (own == chain.end()) continue;
      const bool isOdd = (own - chain.begin()) % 2 != 0;
      local_.piece.colours.emplace_back(*own, loops.colour(starts_[c]) != isOdd);
    }
  }

  void addIsolated(PlaceId id) {
    if (!front_.isUsed(id) || !front_.isIsolated(id) || isHidden(id)) return;
    if (length(chart_.project(front_[id].point).position - middle_) > reach_) return;
    local_.piece.isolated.push_back(vertexAt(id));
  }

  const Front& front_;
  const StepChart& chart_;
  PlaceId base_;
  double reach_;
  Point2 middle_;
  std::vector<bool> isKept_;  ///< by place: whether the edge that leaves it is still to be added
  std::map<std::tuple<std::size_t, double, double>, std::size_t> numbers_;
  std::vector<PlaceId> starts_;  ///< by chain of the piece
  LocalFront local_;
};

}  // namespace

LocalFront localFront(const Front& front, const StepChart& chart, PlaceId base, double size,
                      double reach) {
  Cutter cutter(front, chart, base, reach);
  const std::pair edge{cutter.vertexAt(base), cutter.vertexAt(front.next(base))};
  LocalFront local = cutter.cut();
  local.piece.base = edge;
  local.piece.level = front[base].level;
  local.piece.size = size;
  return local;
}

}  // namespace af2
