// Conversions between OpenCASCADE's points and those of AF2.
#pragma once

#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "engine/base/point.h"

namespace af2::geometry {

inline Point3 toPoint(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }
inline Point3 toPoint(const gp_Vec& p) { return {p.X(), p.Y(), p.Z()}; }
inline Point3 toPoint(const gp_Dir& p) { return {p.X(), p.Y(), p.Z()}; }
inline gp_Pnt toOcc(const Point3& p) { return {p.x, p.y, p.z}; }

}  // namespace af2::geometry
