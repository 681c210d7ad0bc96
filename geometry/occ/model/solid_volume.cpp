#include "geometry/occ/model/solid_volume.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <cmath>

namespace af2::geometry {

std::optional<double> volumeOfSolids(const ModelShape& model) {
  if (TopExp_Explorer(model.shape, TopAbs_FACE, TopAbs_SOLID).More()) return std::nullopt;
  try {
    double sum = 0;
    for (TopExp_Explorer it(model.shape, TopAbs_SOLID); it.More(); it.Next()) {
      GProp_GProps volume;
      BRepGProp::VolumeProperties(it.Current(), volume);
      sum += volume.Mass();
    }
    if (std::isfinite(sum)) return sum;
  } catch (const Standard_Failure&) {
  }
  return std::nullopt;
}

}  // namespace af2::geometry
