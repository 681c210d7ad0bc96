#include "geometry/fill/drawn_front.h"

#include <limits>

namespace af2::geometry {

DrawnFront::DrawnFront(std::vector<Vertex> vertices) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  low_ = {kFar, kFar};
  high_ = {-kFar, -kFar};
  for (const auto& [id, p] : vertices) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  isLongInX_ = high_.x - low_.x >= high_.y - low_.y;
  std::ranges::sort(vertices, {}, [&](const Vertex& v) { return std::pair(along(v.place), v.id); });
  for (const Vertex& v : vertices) {
    ranks_.emplace(v.id, positions_.size());
    positions_.push_back(v.place);
  }
  firstAt_.assign(positions_.size(), kNone);
}

void DrawnFront::add(DrawnEdge edge) {
  const auto number = static_cast<std::uint32_t>(edges_.size());
  if (!index_.emplace(edge, number).second) return;
  const std::size_t from = ranks_.at(edge.from), to = ranks_.at(edge.to);
  const Point2 a = positions_[from], b = positions_[to];
  edges_.push_back({edge, a, b, firstAt_[from]});
  firstAt_[from] = number;
  longest_ = std::max(longest_, std::abs(along(b) - along(a)));
  byLength_.emplace(distance(a, b), edge);
}

bool DrawnFront::takeOut(DrawnEdge edge) {
  const auto found = index_.find(edge);
  if (found == index_.end()) return false;
  const Entry& taken = edges_[found->second];
  std::uint32_t* at = &firstAt_[ranks_.at(edge.from)];
  while (*at != found->second) at = &edges_[*at].next;
  *at = taken.next;
  byLength_.erase({distance(taken.from, taken.to), edge});
  index_.erase(found);
  return true;
}

}  // namespace af2::geometry
