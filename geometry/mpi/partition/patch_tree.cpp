#include "geometry/mpi/partition/patch_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace af2::mpi {

namespace {

constexpr std::uint32_t kUnnumbered = std::numeric_limits<std::uint32_t>::max();

double along(const Point3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// The axis along which the points extend most, and how far.
std::pair<int, double> longestExtent(std::span<const Point3> points) {
  std::pair<int, double> longest{0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] =
        std::ranges::minmax(points, {}, [&](const Point3& p) { return along(p, axis); });
    const double extent = along(high, axis) - along(low, axis);
    if (extent > longest.second) longest = {axis, extent};
  }
  return longest;
}

/// Where to cut so that both sides have points, and about as many.
double middleCut(std::span<Point3> points, int axis) {
  const auto position = [&](const Point3& p) { return along(p, axis); };
  const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
  std::ranges::nth_element(points, middle, {}, position);
  const double cut = position(*middle), lowest = position(std::ranges::min(points, {}, position));
  if (cut > lowest) return cut;
  double next = std::numeric_limits<double>::infinity();
  for (const Point3& p : points)
    if (position(p) > lowest) next = std::min(next, position(p));
  return next;
}

}  // namespace

PatchTree::PatchTree(std::span<const Point3> points, std::size_t most) : nodes_(1) {
  std::vector<Point3> all(points.begin(), points.end());
  std::vector<std::pair<std::size_t, std::span<Point3>>> undivided{{0, all}};
  while (!undivided.empty()) {
    const auto [node, some] = undivided.back();
    undivided.pop_back();
    const auto [axis, extent] = longestExtent(some);
    if (some.size() <= most || extent == 0) continue;
    const double cut = middleCut(some, axis);
    const auto above =
        std::ranges::partition(some, [&, a = axis](const Point3& p) { return along(p, a) < cut; });
    const auto below = some.size() - above.size();
    nodes_[node] = {cut, axis, static_cast<std::uint32_t>(nodes_.size())};
    undivided.emplace_back(nodes_.size(), some.first(below));
    undivided.emplace_back(nodes_.size() + 1, some.subspan(below));
    nodes_.resize(nodes_.size() + 2);
  }
  for (Node& node : nodes_)
    if (node.axis == kLeaf) node.next = kUnnumbered;
  for (const Point3& point : points) {
    std::uint32_t& patch = nodes_[leafOf(point)].next;
    if (patch == kUnnumbered) patch = static_cast<std::uint32_t>(count_++);
  }
}

std::size_t PatchTree::leafOf(const Point3& point) const {
  std::size_t node = 0;
  while (nodes_[node].axis != kLeaf)
    node = nodes_[node].next + (along(point, nodes_[node].axis) < nodes_[node].cut ? 0 : 1);
  return node;
}

std::uint32_t PatchTree::of(const Point3& point) const { return nodes_[leafOf(point)].next; }

}  // namespace af2::mpi
