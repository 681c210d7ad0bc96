#include "geometry/base/box_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace af2::geometry {
Segment3::Segment3(const Point3& from, const Point3& to)
    : middle_(0.5 * (from + to)),
      half_(0.5 * (to - from)),
      reach_{std::abs(half_.x), std::abs(half_.y), std::abs(half_.z)} {}

/// They are apart if a direction parts them: across the sides of the box, or across the segment and
/// a side.
bool Segment3::meets(const Box3& box) const {
  constexpr double kSlack = 1 + 1e-12;
  const Point3 h = (0.5 * kSlack) * (box.high - box.low), d = middle_ - 0.5 * (box.low + box.high);
  const auto apart = [](double between, double reach) {
    return std::abs(between) > kSlack * reach + 1e-300;
  };
  if (apart(d.x, h.x + reach_.x) || apart(d.y, h.y + reach_.y) || apart(d.z, h.z + reach_.z))
    return false;
  return !(apart(half_.y * d.z - half_.z * d.y, h.y * reach_.z + h.z * reach_.y) ||
           apart(half_.z * d.x - half_.x * d.z, h.x * reach_.z + h.z * reach_.x) ||
           apart(half_.x * d.y - half_.y * d.x, h.x * reach_.y + h.y * reach_.x));
}

BoxTree::BoxTree(const std::vector<Box3>& boxes) : order_(boxes.size()) {
  if (boxes.empty()) return;
  std::iota(order_.begin(), order_.end(), 0u);
  std::size_t size = 1;
  for (std::size_t count = boxes.size(); count > kLeaf; count -= count / 2) size = 2 * size + 1;
  nodes_.resize(size);
  build(boxes, 0, 0, boxes.size());
  for (const std::uint32_t i : order_) leaves_.push_back(boxes[i]);
}

void BoxTree::build(const std::vector<Box3>& boxes, std::size_t node, std::size_t first,
                    std::size_t last) {
  Box3 all;
  for (std::size_t i = first; i < last; ++i) all.add(boxes[order_[i]]);
  nodes_[node] = all;
  if (last - first <= kLeaf) return;
  const Point3 extent = all.high - all.low;
  const auto key = [&](std::uint32_t i) {
    const Point3 c = boxes[i].low + boxes[i].high;
    if (extent.x >= extent.y && extent.x >= extent.z) return std::tuple(c.x, i);
    return extent.y >= extent.z ? std::tuple(c.y, i) : std::tuple(c.z, i);
  };
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t half = middle(first, last);
  std::nth_element(at(first), at(half), at(last),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  build(boxes, 2 * node + 1, first, half);
  build(boxes, 2 * node + 2, half, last);
}

}  // namespace af2::geometry
