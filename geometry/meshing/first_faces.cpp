#include "geometry/meshing/first_faces.h"

#include <algorithm>
#include <numeric>

namespace af2::geometry {

namespace {

/// Of the work. With more, much is meshed twice if a face asks; with less, more faces ask when it
/// is too late.
constexpr double kShareOfSmall = 0.2;

}  // namespace

std::vector<bool> smallFaces(const std::vector<double>& work) {
  std::vector<std::size_t> order(work.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return work[i]; });
  double left = kShareOfSmall * std::accumulate(work.begin(), work.end(), 0.0);
  std::vector<bool> isSmall(work.size(), false);
  for (const std::size_t i : order) {
    left -= work[i];
    if (left < 0) break;
    isSmall[i] = true;
  }
  return isSmall;
}

}  // namespace af2::geometry
