// The wanted size on one face.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <optional>

#include "engine/surface/size_field.h"
#include "geometry/occ/sizes/cad_sizes.h"
#include "geometry/occ/sizes/sizing.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

/// The size from the options, limited by curvature.
class FaceSize final : public SizeField {
 public:
  FaceSize(const CadSizes& sizes, int face, const FaceSurface& surface);
  double sizeAt(const SurfacePoint& point) const override;
  /// The smallest size that is allowed at a point.
  double leastAt(const SurfacePoint& point) const { return curvedAt(point).least; }

 private:
  CurvedSize curvedAt(const SurfacePoint& point) const;

  const CadSizes& sizes_;
  const FaceSurface& surface_;
  int face_;
  double wanted_;
  std::optional<CurvedSize> alike_;  ///< where the surface is bent alike everywhere
};

}  // namespace af2::geometry
