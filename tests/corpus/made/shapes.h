// What several families are made from.
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <functional>
#include <vector>

#include "tests/corpus/made/draw.h"

namespace af2::made {

/// A box, cylinder, cone, sphere or torus of about a given size near the origin.
TopoDS_Shape primitive(Draw& draw, double size);

TopoDS_Shape fused(const TopoDS_Shape& first, const TopoDS_Shape& second);
TopoDS_Shape cut(const TopoDS_Shape& first, const TopoDS_Shape& second);

/// Parts that stay apart.
TopoDS_Shape compound(const std::vector<TopoDS_Shape>& parts);

std::vector<TopoDS_Shape> edgesOf(const TopoDS_Shape& shape);
std::vector<TopoDS_Shape> facesOf(const TopoDS_Shape& shape);

/// A point at so many turns around the z axis.
gp_Pnt around(double radius, double turn, double z = 0);

/// A closed wire of straight edges.
TopoDS_Wire polygon(const std::vector<gp_Pnt>& corners);

TopoDS_Wire circle(const gp_Ax2& axes, double radius);

/// One edge along a spline through points; closed and smooth, or from the first to the last.
enum class Ends { Apart, Joined };
TopoDS_Wire splineWire(const std::vector<gp_Pnt>& points, Ends ends = Ends::Apart);

TopoDS_Face flatFace(const TopoDS_Wire& outer, const std::vector<TopoDS_Wire>& holes = {});

TopoDS_Shape extruded(const TopoDS_Shape& base, const gp_Vec& along);

/// A spline surface through a grid of points, the function of two numbers from 0 to 1.
TopoDS_Face surfaceThrough(int rows, int columns,
                           const std::function<gp_Pnt(double, double)>& point);

}  // namespace af2::made
