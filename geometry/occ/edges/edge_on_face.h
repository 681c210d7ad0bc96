// Finds the places of the points of an edge in the parameters of a face.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <Geom2d_Curve.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pln.hxx>
#include <gp_Pnt2d.hxx>
#include <optional>
#include <vector>

#include "geometry/edges/divided_edges.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

/// The places of the points of an edge in the parameters of a face.
class EdgeOnFace {
 public:
  /// plane  of the face, if it is plane
  /// box    the part of the parameters that the face occupies
  ///
  /// All arguments except the box are kept as references.
  EdgeOnFace(const TopoDS_Edge& edge, const TopoDS_Face& face, const std::optional<gp_Pln>& plane,
             const SplineSurface::Box& box);

  gp_Pnt2d at(double parameter, const Point3& position);

  /// Whether the curve in the parameters is far from the curve in space: a deviation of `most`
  /// means that it is elsewhere on the face.
  bool isAstray(const DividedEdge& divided, const std::vector<Point3>& points,
                const FaceSurface& surface) const;

  bool lacksCurve() const { return !plane_ && curve_.IsNull(); }
  void dropCurve() { curve_.Nullify(); }

 private:
  gp_Pnt2d onCurve(double parameter) const;
  gp_Pnt2d inPlane(const Point3& position) const;
  gp_Pnt2d project(const Point3& position);
  gp_Pnt2d withinBox(gp_Pnt2d uv) const;

  const TopoDS_Face& face_;
  const std::optional<gp_Pln>& plane_;
  SplineSurface::Box box_;
  Handle(Geom2d_Curve) curve_;
  Handle(ShapeAnalysis_Surface) analysis_;
  gp_Pnt2d previous_;
  bool hasPrevious_ = false;
  double first_ = 0, last_ = 1, curveFirst_ = 0, curveLast_ = 1;
};

/// The normal du x dv of the surface at a place of an edge, independent of the orientation of the
/// face; of any length, and 0 if unknown.
Point3 normalOnEdge(const FaceSurface& surface, const TopoDS_Face& face, const TopoDS_Edge& edge,
                    double parameter);

}  // namespace af2::geometry
