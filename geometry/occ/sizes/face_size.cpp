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
  return curvedSizeAt(sizes_, face_, wanted_, surface_, point);
}

double FaceSize::sizeAt(const SurfacePoint& point) const {
  const CurvedSize curved = alike_ ? *alike_ : curvedAt(point);
  return bounded(sizes_, curved,
                 limitByFunction(sizes_, curved.share * curved.limit, point.position));
}

}  // namespace af2::geometry
