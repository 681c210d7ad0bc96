#include "geometry/occ/open_ends.h"

#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <map>

namespace af2::geometry {

namespace {

/// By point: how many edges of a wire start there, less how many end there.
std::map<std::uint32_t, int> balanceOf(const ModelShape& model, const TopoDS_Face& face,
                                       const std::vector<Ends>& ends,
                                       const std::vector<bool>& isUsed) {
  std::map<std::uint32_t, int> balance;
  for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next()) {
    const TopAbs_Orientation way = it.Current().Orientation();
    const auto edge = static_cast<std::size_t>(model.edges.FindIndex(it.Current())) - 1;
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
  for (int id = 1; id <= model.faces.Extent(); ++id) {
    std::map<std::uint32_t, int> balance = balanceOf(model, model.face(id), ends, isUsed);
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
