#include "geometry/occ/surfaces/surface_breaks.h"

#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>

namespace af2::geometry {

std::vector<double> breaksOf(const GeomAdaptor_Surface& surface, bool isInU, double low,
                             double high) {
  constexpr double kSame = 1e-7;  // of the range
  const int count = isInU ? surface.NbUIntervals(GeomAbs_C1) : surface.NbVIntervals(GeomAbs_C1);
  if (count < 1) return {};
  TColStd_Array1OfReal bounds(1, count + 1);
  isInU ? surface.UIntervals(bounds, GeomAbs_C1) : surface.VIntervals(bounds, GeomAbs_C1);
  const bool isPeriodic = isInU ? surface.IsUPeriodic() : surface.IsVPeriodic();
  std::vector<double> breaks;
  for (const double bound : bounds) {
    if (!isPeriodic) {
      breaks.push_back(bound);
      continue;
    }
    const double period = isInU ? surface.UPeriod() : surface.VPeriod();
    for (double b = bound - std::ceil((bound - low) / period) * period; b <= high; b += period)
      breaks.push_back(b);
  }
  std::ranges::sort(breaks);
  const auto isSame = [&](double a, double b) { return b - a < kSame * (high - low); };
  breaks.erase(std::unique(breaks.begin(), breaks.end(), isSame), breaks.end());
  return breaks;
}

}  // namespace af2::geometry
