// A custom geometry engine: a torus given by formulas, and its charts. No CAD kernel.
#pragma once

#include <af2/engine/front_input.h>
#include <af2/engine/local_transform.h>

/// The torus around the z axis.
struct Torus {
  double ring = 3;  ///< radius of the centre circle of the tube
  double tube = 1;  ///< radius of the tube, < ring

  /// u goes around the axis, v around the tube; both in radians.
  af2::SurfacePoint at(double u, double v) const;
  /// The outward unit normal at a point on, or near, the surface.
  af2::Point3 normalAt(const af2::Point3& p) const;
  /// The nearest point to its start where the line start + t * direction meets the surface, if any.
  std::optional<af2::SurfacePoint> hit(const af2::Point3& start,
                                       const af2::Point3& direction) const;
};

/// The interface that AF2 needs from a surface: a chart for each step of the advance. This chart is
/// the plane normal to the mean of the two end normals. Points are projected onto the plane, and
/// mapped back along its normal.
class TorusChartMaker final : public af2::AF2LocalTransformMaker {
 public:
  explicit TorusChartMaker(const Torus& torus) : torus_(torus) {}

  std::unique_ptr<af2::AF2LocalTransform> makeLocalTransform(const af2::SurfacePoint& from,
                                                             const af2::SurfacePoint& to,
                                                             double edgeLength) const override;

 private:
  Torus torus_;
};

/// The torus cut open along two circles (v = 0 and u = 0), so that one loop bounds all of it. Each
/// circle is divided into pieces of about `size`. Each piece is a boundary edge twice, once from
/// either side, with the same two vertices.
af2::FrontInput cutOpen(const Torus& torus, double size);
