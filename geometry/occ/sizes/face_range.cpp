#include "geometry/occ/sizes/face_range.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <algorithm>
#include <limits>

namespace af2::geometry {

SplineSurface::Box rangeOf(const TopoDS_Face& face, const FaceSurface& surface) {
  if (!surface.isPlane()) return surface.box();
  Bnd_Box around;
  BRepBndLib::Add(face, around, false);
  if (around.IsVoid() || around.IsOpen()) return surface.box();
  Point3 low, high;
  around.Get(low.x, low.y, low.z, high.x, high.y, high.z);
  const SurfaceFrame frame = surface.inOccParameters().frameAt(0, 0);
  constexpr double kNone = std::numeric_limits<double>::infinity();
  SplineSurface::Box range{kNone, -kNone, kNone, -kNone};
  for (const double x : {low.x, high.x})
    for (const double y : {low.y, high.y})
      for (const double z : {low.z, high.z}) {
        const Point3 away = Point3{x, y, z} - frame.position;
        const double u = dot(away, frame.du), v = dot(away, frame.dv);
        range = {std::min(range.u1, u), std::max(range.u2, u),  //
                 std::min(range.v1, v), std::max(range.v2, v)};
      }
  return range;
}

}  // namespace af2::geometry
