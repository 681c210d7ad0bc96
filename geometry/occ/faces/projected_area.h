// The area of a face seen along a direction, from its boundary.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <optional>

#include "engine/base/point.h"

namespace af2::geometry {

/// The integral of normal . direction over a face, whatever its surface: by Stokes' theorem that of
/// the triangles from some point to the boundary. For a plane and its normal, the area. The edges
/// are taken in space: many files have no curves in the parameters of planes, and to make them
/// takes long. Use it with addBoundary.
class ProjectedArea {
 public:
  explicit ProjectedArea(const Point3& direction) : direction_(direction) {}

  void add(const TopoDS_Edge& edge);
  void endWire() {}
  double sum() const { return sum_; }

 private:
  double between(const Point3& p, const Point3& d) const;
  double gaps(const TopoDS_Edge& edge, const Point3& start, const Point3& end) const;
  double triangles(const BRepAdaptor_Curve& curve, const Point3& start, const Point3& end) const;

  Point3 direction_;
  std::optional<Point3> origin_;
  double sum_ = 0, extent_ = 0;
};

}  // namespace af2::geometry
