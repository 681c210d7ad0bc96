// The size that the adjacent faces want along an edge.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <Geom2d_Curve.hxx>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/sizes/cad_sizes.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

/// For the calling thread alone.
class WantedAlongEdge {
 public:
  WantedAlongEdge(const ModelShape& model, int edge, const CadSizes& sizes);

  /// An upper bound of the sizes.
  double largest() const { return largest_; }

  /// The smallest bound on the distance from the model of the faces beside; infinite: none.
  double chord() const { return chord_; }

  struct Size {
    double wanted;
    double least;  ///< lower bound of all sizes there
  };
  /// The size without bounds and without the limits by position, which are evaluated for a whole
  /// piece at once.
  Size at(const Point3& position, double parameter) const;

 private:
  struct Neighbor {
    int id;
    double wanted;
    std::optional<FaceSurface> surface;
    Handle(Geom2d_Curve) curve;
  };
  void addFace(const ModelShape& model, int edge, int face);
  Size onFace(const Neighbor& face, const Point3& position, double parameter) const;

  const CadSizes& sizes_;
  std::vector<Neighbor> faces_;
  double largest_;
  double chord_ = std::numeric_limits<double>::infinity();
};

}  // namespace af2::geometry
