#include "geometry/reading/field_cells.h"

#include <algorithm>

namespace af2::geometry {
namespace {

using Corners = std::array<int, 4>;

// How larger cells are cut into smaller ones.
constexpr std::array kOfQuad{Corners{0, 1, 2, -1}, Corners{0, 2, 3, -1}};
constexpr std::array kOfPyramid{Corners{0, 1, 2, 4}, Corners{0, 2, 3, 4}};
constexpr std::array kOfPrism{Corners{0, 1, 2, 5}, Corners{0, 1, 5, 4}, Corners{0, 4, 5, 3}};
constexpr std::array kOfCube{Corners{0, 1, 2, 6}, Corners{0, 2, 3, 6}, Corners{0, 3, 7, 6},
                             Corners{0, 7, 4, 6}, Corners{0, 4, 5, 6}, Corners{0, 5, 1, 6}};

std::span<const Corners> partsOf(std::size_t corners, int dimension) {
  if (dimension == 2 && corners == 4) return kOfQuad;
  if (dimension == 3 && corners == 5) return kOfPyramid;
  if (dimension == 3 && corners == 6) return kOfPrism;
  if (dimension == 3 && corners == 8) return kOfCube;
  return {};
}

}  // namespace

void FieldCells::add(std::span<const std::uint64_t> corners, int dimension) {
  const auto parts = partsOf(corners.size(), dimension);
  for (const Corners& part : parts) {
    auto& cell = cells.emplace_back();
    for (std::size_t i = 0; i < 4; ++i)
      cell[i] = part[i] < 0 ? kNoCorner : corners[static_cast<std::size_t>(part[i])];
  }
  if (!parts.empty() || corners.size() > 4) return;
  auto& cell = cells.emplace_back();
  cell.fill(kNoCorner);
  std::ranges::copy(corners, cell.begin());
}

void FieldCells::addValues(const std::string& name, std::size_t first,
                           const std::vector<double>& values) {
  std::vector<double>& all = arrays[name];
  all.resize(std::max(all.size(), first + values.size()), kMissing);
  std::ranges::copy(values, all.begin() + static_cast<std::ptrdiff_t>(first));
}

}  // namespace af2::geometry
