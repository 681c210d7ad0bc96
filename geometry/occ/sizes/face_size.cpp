#include "geometry/occ/sizes/face_size.h"

namespace af2::geometry {

FaceSize::FaceSize(const CadSizes& sizes, int face, const FaceSurface& surface)
    : sizes_(sizes), surface_(surface), face_(face), wanted_(wantedOnFace(sizes, face)) {
  if (surface.isPlane())
    alike_ = {wanted_, 1, sizes.minSize};
  else if (surface.isBentAlike())
    alike_ = curvedAt({});
}

CurvedSize FaceSize::curvedAt(const SurfacePoint& point) const {
  return alike_ ? *alike_ : curvedSizeAt(sizes_, face_, wanted_, surface_, point);
}

double FaceSize::sizeAt(const SurfacePoint& point) const {
  const CurvedSize curved = curvedAt(point);
  const double size = curved.share * curved.limit;
  const bool canBeLess = size > curved.least;
  return bounded(sizes_, curved, canBeLess ? limitByFunction(sizes_, size, point.position) : size);
}

}  // namespace af2::geometry
