// Small models of several parts.
#pragma once

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <vector>

#include "tests/geometry/occ/shapes.h"

namespace af2::testing {

inline TopoDS_Shape boxBetween(const gp_Pnt& low, const gp_Pnt& high) {
  return BRepPrimAPI_MakeBox(low, high).Shape();
}

inline TopoDS_Compound compoundOf(const std::vector<TopoDS_Shape>& parts) {
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& part : parts) builder.Add(all, part);
  return all;
}

/// A model of parts with names.
inline geometry::Model assemblyOf(const std::vector<std::pair<std::string, TopoDS_Shape>>& parts) {
  geometry::ReadShape read;
  std::vector<TopoDS_Shape> shapes;
  for (const auto& [name, shape] : parts) {
    shapes.push_back(shape);
    read.groups.push_back({name, geometry::GroupKind::Part, {shape}});
  }
  read.shape = compoundOf(shapes);
  return geometry::Model(geometry::makeModelShape(std::move(read)));
}

/// A cylinder of radius 1 and height 3 that stands on a plate of 10 x 10 x 1.
inline geometry::Model boltOnPlate() {
  const gp_Ax2 axis({5, 5, 1}, {0, 0, 1});
  return assemblyOf({{"plate", boxBetween({0, 0, 0}, {10, 10, 1})},
                     {"bolt", BRepPrimAPI_MakeCylinder(axis, 1, 3).Shape()}});
}

/// Boxes that have a part of a face in common: 2 x 3.
inline geometry::Model touchingBoxes() {
  return assemblyOf(
      {{"left", boxBetween({0, 0, 0}, {4, 4, 4})}, {"right", boxBetween({4, 2, 1}, {7, 6, 4})}});
}

/// Three boxes around the z axis; all have the edge on it in common.
inline geometry::Model threeBoxes() {
  return assemblyOf({{"a", boxBetween({0, 0, 0}, {2, 2, 3})},
                     {"b", boxBetween({-2, 0, 0}, {0, 2, 3})},
                     {"c", boxBetween({-2, -2, 0}, {0, 0, 3})}});
}

/// Boxes of 64 and 27 that have 1 x 2 x 3 in common.
inline geometry::Model overlappingBoxes() {
  return assemblyOf(
      {{"first", boxBetween({0, 0, 0}, {4, 4, 4})}, {"second", boxBetween({3, 2, 1}, {6, 5, 4})}});
}

/// A sheet of 2 x 2 on a box.
inline geometry::Model sheetOnBox() {
  return assemblyOf(
      {{"block", boxBetween({0, 0, -3}, {4, 4, 0})}, {"label", plane({rectangle(1, 1, 3, 3)})}});
}

}  // namespace af2::testing
