// A cone unrolled into the plane: an isometry, with its tip as an ordinary point.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <gp_Cone.hxx>

#include "geometry/metric_chart.h"
#include "geometry/occ/general_surface.h"

namespace af2::geometry {

class DevelopedCone final : public ParametricSurface {
 public:
  /// surface       the cone in OpenCASCADE's parameters
  /// middleU       angle that lies on the x axis: the middle of the face, so that a whole turn fits
  /// v             of some place of the face, which tells its nappe
  DevelopedCone(const gp_Cone& cone, const GeneralSurface& surface, double middleU, double v);

  /// From OpenCASCADE's parameters.
  Point2 develop(double u, double v) const;

  Frame frameAt(double x, double y) const override;
  SurfacePoint pointAt(double x, double y) const override;
  bool isFlipped() const override { return isFlipped_; }

 private:
  /// The ruling through a point of the plane, in OpenCASCADE's angle.
  double angleAt(double x, double y) const;

  GeneralSurface surface_;
  Point3 apex_;
  double middleU_, sine_;
  double apexV_, sense_;  ///< distance from the tip = sense * (v - apexV)
  double unitV_;          ///< v at distance 1 from the tip, where directions are well defined
  bool isFlipped_ = false;
};

}  // namespace af2::geometry
