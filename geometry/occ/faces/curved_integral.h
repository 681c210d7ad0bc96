// The integral over a curved face, from its surface and its boundary.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Face.hxx>
#include <functional>

#include "geometry/charts/surface_frame.h"
#include "geometry/occ/faces/boundary_integral.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

/// The integral over the strip of width dv, per dv, from the middle of the box to the u that is
/// given. From the middle, because there the gaps of a boundary that is not quite closed do least
/// harm.
using Strip = std::function<double(double u, double v)>;

/// Strips of any surface, piece by piece between the u where its formula changes. The surface must
/// outlive the result.
///
/// density    what is integrated, per du dv
/// tolerance  of the integral along a piece
Strip summedStrips(const TopoDS_Face& face, const FaceSurface& surface,
                   std::function<double(const SurfaceFrame&)> density, double tolerance);

/// About the area of the box of a surface per dv.
double widthOfBox(const FaceSurface& surface);

/// By Green's theorem the integral over a face is that of the strips up to the boundary over dv,
/// once around the face. Use it with addBoundary.
class CurvedIntegral {
 public:
  /// perStrip  the tolerance per dv
  /// u, v      outside nothing counts
  CurvedIntegral(const TopoDS_Face& face, const SplineSurface::Box& box, Strip strip,
                 double perStrip, const Stretch& u, const Stretch& v);

  /// Throws Standard_Failure if the edge has no curve in the parameters.
  void add(const TopoDS_Edge& edge);
  void endWire();

  /// False if some wire is not closed in the parameters.
  bool isClosed() const { return isClosed_; }
  double sum() const { return sum_; }
  /// The area by which the curves in the parameters may lie beside the edges.
  double doubt() const { return doubt_; }

 private:
  const TopoDS_Face& face_;
  SplineSurface::Box box_;
  Strip strip_;
  Integral integral_;
  Stretch u_, v_;
  double sum_ = 0, gapU_ = 0, gapV_ = 0, doubt_ = 0;
  bool isClosed_ = true;
};

}  // namespace af2::geometry
