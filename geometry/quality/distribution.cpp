#include "geometry/quality/distribution.h"

#include <algorithm>
#include <numeric>

namespace af2::geometry {

Distribution distributionOf(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);  // before the sum, so that the order of elements does not change it
  const auto at = [&](double part) {
    const double place = part * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    if (below + 1 == values.size()) return values.back();
    return values[below] +
           (place - static_cast<double>(below)) * (values[below + 1] - values[below]);
  };
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {values.size(), values.front(), at(0.01),
          at(0.05),      at(0.5),        sum / static_cast<double>(values.size()),
          at(0.95),      at(0.99),       values.back()};
}

}  // namespace af2::geometry
