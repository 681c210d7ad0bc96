#include "geometry/check/element_tree.h"

#include <array>

namespace af2::geometry {
namespace {

/// The lowest ten bits of a number, with two empty bits behind each.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 16) & 0x030000ff;
  bits = (bits | bits << 8) & 0x0300f00f;
  bits = (bits | bits << 4) & 0x030c30c3;
  return (bits | bits << 2) & 0x09249249;
}

/// Sorts numbers by the thirty bits above the lowest 32, and leaves those alike in their order.
void sortByHighBits(std::vector<std::uint64_t>& keys) {
  constexpr int kDigit = 10, kLow = 32, kHigh = kLow + 3 * kDigit;
  std::vector<std::uint64_t> sorted(keys.size());
  for (int shift = kLow; shift < kHigh; shift += kDigit) {
    const auto digit = [&](std::uint64_t key) { return key >> shift & ((1u << kDigit) - 1); };
    std::array<std::size_t, (1u << kDigit) + 1> next{};
    for (const std::uint64_t key : keys) ++next[digit(key) + 1];
    for (std::size_t d = 1; d < next.size(); ++d) next[d] += next[d - 1];
    for (const std::uint64_t key : keys) sorted[next[digit(key)]++] = key;
    keys.swap(sorted);
  }
}

/// The places of points in the order in which a Z-order curve through all of them comes by.
/// point  of each of `count` places
template <class Point>
std::vector<std::uint32_t> alongCurve(std::size_t count, const Point& point) {
  constexpr double kCells = 1023;
  Box3 all;
  for (std::size_t i = 0; i < count; ++i) all.add(point(i));
  const Point3 extent = all.high - all.low;
  const double scale = kCells / std::max({extent.x, extent.y, extent.z, 1e-300});
  const auto cell = [&](double away) { return spread(static_cast<std::uint64_t>(scale * away)); };
  std::vector<std::uint64_t> keys(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Point3 d = point(i) - all.low;
    keys[i] = (cell(d.x) | cell(d.y) << 1 | cell(d.z) << 2) << 32 | i;
  }
  sortByHighBits(keys);
  std::vector<std::uint32_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<std::uint32_t>(keys[i]);
  return order;
}

}  // namespace

ElementTree::ElementTree(const ModelMesh& mesh, std::size_t first,
                         const std::vector<std::uint32_t>& elements)
    : first_(first),
      count_(elements.size()),
      order_(alongCurve(count_, [&](std::size_t i) -> const Point3& {
        return mesh.vertices[mesh.elements[first + elements[i]].corners[0].value];
      })) {
  for (std::uint32_t& place : order_) place = elements[place];
  levels_.emplace_back((count_ + kRun - 1) / kRun);
  for (std::size_t index = 0; index < levels_[0].size(); ++index) {
    const Run leaf = run(index);
    for (std::size_t k = leaf.first; k < leaf.last; ++k)
      for (const VertexId v : mesh.elements[leaf.element(k)].vertices())
        levels_[0][index].add(mesh.vertices[v.value]);
  }
  while (levels_.back().size() > 1) {
    const std::vector<Box3>& below = levels_.back();
    std::vector<Box3> above((below.size() + kBranches - 1) / kBranches);
    for (std::size_t i = 0; i < below.size(); ++i) above[i / kBranches].add(below[i]);
    levels_.push_back(std::move(above));
  }
}

}  // namespace af2::geometry
