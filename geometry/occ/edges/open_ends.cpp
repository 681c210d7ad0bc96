#include "geometry/occ/edges/open_ends.h"

#include <algorithm>
#include <map>

namespace af2::geometry {

namespace {

/// By point: the number of edges of a wire that start there, minus the number that end there.
std::map<std::uint32_t, int> balanceOf(const std::vector<EdgeUse>& uses,
                                       const std::vector<Ends>& ends,
                                       const std::vector<bool>& isUsed) {
  std::map<std::uint32_t, int> balance;
  for (const EdgeUse& use : uses) {
    const TopAbs_Orientation way = use.edge.Orientation();
    const auto edge = static_cast<std::size_t>(use.id) - 1;
    if (!isUsed[edge] || way == TopAbs_INTERNAL || way == TopAbs_EXTERNAL) continue;
    const int step = way == TopAbs_FORWARD ? 1 : -1;
    balance[ends[edge].first] += step;
    balance[ends[edge].last] -= step;
  }
  return balance;
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> gapsInWires(
    const ModelShape& model, const std::vector<Ends>& ends, const std::vector<bool>& isUsed,
    const std::vector<Point3>& points, const std::vector<double>& tolerance) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> gaps;
  for (const std::vector<EdgeUse>& uses : model.edgesOfFaces) {
    std::map<std::uint32_t, int> balance = balanceOf(uses, ends, isUsed);
    for (auto& [end, missing] : balance) {
      while (missing < 0) {  // a wire ends here: where does it go on?
        auto nearest = balance.end();
        double least = 0;
        for (auto start = balance.begin(); start != balance.end(); ++start) {
          if (start->second <= 0) continue;
          const double gap = distance(points[end], points[start->first]);
          if (gap > tolerance[end] + tolerance[start->first]) continue;
          if (nearest != balance.end() && gap >= least) continue;
          nearest = start;
          least = gap;
        }
        if (nearest == balance.end()) break;
        gaps.emplace_back(end, nearest->first);
        ++missing;
        --nearest->second;
      }
    }
  }
  return gaps;
}

}  // namespace af2::geometry
