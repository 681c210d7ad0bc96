#include "geometry/charts/offset_surface.h"

namespace af2::geometry {

/// With the unit normal n of both surfaces, du of the offset is that of the base + offset * dn/du.
/// As du is at right angles to n everywhere, duu * n = -du * dn/du, and so on.
std::optional<SurfaceJet> offsetBend(const SurfaceJet& base, double offset) {
  constexpr double kDegenerate = 1e-6;  // sine of the angle between du and dv
  const Point3 across = cross(base.du, base.dv);
  const double area = length(across);
  if (!(area > kDegenerate * length(base.du) * length(base.dv))) return std::nullopt;
  const Point3 normal = (1 / area) * across;
  const auto turn = [&](const Point3& change) {  // of the unit normal, from that of du x dv
    return (1 / area) * (change - dot(change, normal) * normal);
  };
  const Point3 alongU = turn(cross(base.duu, base.dv) + cross(base.du, base.duv)),
               alongV = turn(cross(base.duv, base.dv) + cross(base.du, base.dvv));
  SurfaceJet bend;
  bend.position = base.position + offset * normal;
  bend.du = base.du + offset * alongU;
  bend.dv = base.dv + offset * alongV;
  bend.duu = -dot(bend.du, alongU) * normal;
  bend.duv = -dot(bend.du, alongV) * normal;
  bend.dvv = -dot(bend.dv, alongV) * normal;
  return bend;
}

}  // namespace af2::geometry
