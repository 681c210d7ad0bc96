// Models made in memory.
#pragma once

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>

#include "geometry/occ/model.h"
#include "geometry/occ/model_shape.h"

namespace af2::testing {

inline geometry::Model modelOf(const TopoDS_Shape& shape) {
  geometry::ReadShape read;
  read.shape = shape;
  return geometry::Model(geometry::makeModelShape(std::move(read)));
}

inline geometry::Model box(double x, double y, double z) {
  return modelOf(BRepPrimAPI_MakeBox(x, y, z).Shape());
}
inline geometry::Model cylinder(double radius, double height) {
  return modelOf(BRepPrimAPI_MakeCylinder(radius, height).Shape());
}
inline geometry::Model cone(double low, double high, double height) {
  return modelOf(BRepPrimAPI_MakeCone(low, high, height).Shape());
}
inline geometry::Model sphere(double radius) {
  return modelOf(BRepPrimAPI_MakeSphere(radius).Shape());
}
inline geometry::Model torus(double major, double minor) {
  return modelOf(BRepPrimAPI_MakeTorus(major, minor).Shape());
}

}  // namespace af2::testing
