#include "geometry/occ/face_size.h"

#include "geometry/occ/sizing.h"

namespace af2::geometry {

FaceSize::FaceSize(const ModelSizes& sizes, int face, const FaceSurface& surface)
    : sizes_(sizes), surface_(surface), wanted_(wantedOnFace(sizes, face)) {}

double FaceSize::sizeAt(const SurfacePoint& point) const {
  const double size = surface_.isPlane()
                          ? wanted_
                          : sizes_.curvedShare * limitByCurvature(sizes_, wanted_, surface_, point);
  return bounded(sizes_, limitByFunction(sizes_, size, point.position));
}

}  // namespace af2::geometry
