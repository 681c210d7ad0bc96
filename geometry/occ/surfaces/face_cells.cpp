#include "geometry/occ/surfaces/face_cells.h"

namespace af2::geometry {

bool isIn(const FaceCell& cell, const FaceCells& cells, double u, double v, double share) {
  const auto has = [&](const std::vector<Stretch>& stretches, std::size_t i, double at) {
    const double slack = share * (stretches.back().high - stretches.front().low);
    const bool isFirst = i == 0, isLast = i + 1 == stretches.size();
    return (isFirst || at >= stretches[i].low - slack) &&
           (isLast || at <= stretches[i].high + slack);
  };
  return has(cells.u, cell.u, u) && has(cells.v, cell.v, v);
}

double calm(const std::vector<Stretch>& stretches, double parameter) {
  if (stretches.empty()) return parameter;
  auto stretch = stretches.begin();
  while (stretch + 1 != stretches.end() && parameter >= (stretch + 1)->low) ++stretch;
  return stretch->calm(parameter);
}

}  // namespace af2::geometry
