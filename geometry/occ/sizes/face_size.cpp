#include "geometry/occ/sizes/face_size.h"

#include "geometry/occ/sizes/sizing.h"

namespace af2::geometry {

FaceSize::FaceSize(const CadSizes& sizes, int face, const FaceSurface& surface)
    : sizes_(sizes),
      surface_(surface),
      face_(face),
      wanted_(wantedOnFace(sizes, face)),
      isBentAlike_(surface.isBentAlike()) {
  if (isBentAlike_ && !surface.isPlane()) wanted_ = limitedAt({});
}

double FaceSize::limitedAt(const SurfacePoint& point) const {
  const CurvedSize curved = curvedSizeAt(sizes_, face_, wanted_, surface_, point);
  return curved.share * curved.limit;
}

double FaceSize::sizeAt(const SurfacePoint& point) const {
  const double size = isBentAlike_ ? wanted_ : limitedAt(point);
  return bounded(sizes_, limitByFunction(sizes_, size, point.position));
}

}  // namespace af2::geometry
